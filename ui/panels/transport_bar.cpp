#include "panels/transport_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <algorithm>

#include "drawing/cause_style.h"
#include "theme/control_name.h"
#include "theme/icons.h"

namespace toolpace::ui {
namespace {

constexpr std::array kRates = {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0};
constexpr int kRealTime = 3;
constexpr int kPatienceMs = 200;

}  // namespace

TransportBar::TransportBar(QWidget* parent) : QWidget(parent) {
  setObjectName("transportBar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  row->setSpacing(4);
  first_ = addButton("firstButton", "first", &TransportBar::firstRequested);
  previous_ = addButton("previousButton", "previous", &TransportBar::previousRequested);
  play_ = addButton("playButton", "play", &TransportBar::playRequested);
  next_ = addButton("nextButton", "next", &TransportBar::nextRequested);
  last_ = addButton("lastButton", "last", &TransportBar::lastRequested);
  rate_ = new QComboBox(this);
  rate_->setObjectName("rateBox");
  for (double rate : kRates) rate_->addItem("×" + QString::number(rate), rate);
  rate_->setCurrentIndex(kRealTime);
  connect(rate_, &QComboBox::currentIndexChanged, this,
          [this](int index) { emit rateChanged(rate_->itemData(index).toDouble()); });
  row->addWidget(rate_);
  row->addSpacing(12);
  const auto label = [this, row](const char* name, bool secondary) {
    auto* result = new QLabel(this);
    result->setObjectName(name);
    result->setTextFormat(Qt::PlainText);
    if (secondary) result->setProperty("role", "secondary");
    row->addWidget(result);
    row->addSpacing(12);
    return result;
  };
  time_ = label("timeReadout", false);
  place_ = label("positionReadout", false);
  motion_ = label("motionReadout", false);
  message_ = label("messageReadout", true);
  message_->setSizePolicy(QSizePolicy::Ignored,
                          QSizePolicy::Preferred);  // a long message is no reason to widen the window
  row->setStretchFactor(message_, 1);
  busy_ = label("busyLabel", true);
  progress_ = new QProgressBar(this);
  progress_->setObjectName("progressBar");
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(120);
  row->addWidget(progress_);
  cancel_ = addButton("cancelButton", "cancel", &TransportBar::cancelRequested);
  patience_.setSingleShot(true);
  patience_.setInterval(kPatienceMs);
  connect(&patience_, &QTimer::timeout, this, [this] { showBusy(true); });
  setTheme(theme_);
  retranslate();
  setBusy(false);
}

QToolButton* TransportBar::addButton(const char* name, const char* icon_name, void (TransportBar::*signal)()) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setProperty("icon_name", icon_name);
  button->setIconSize({20, 20});
  connect(button, &QToolButton::clicked, this, signal);
  layout()->addWidget(button);
  return button;
}

void TransportBar::showInstant(const std::optional<Instant>& instant) {
  instant_ = instant;
  refresh();
}

void TransportBar::setBlockName(const QString& name) { block_name_ = name; }

QString TransportBar::steady(Number number, double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  if (text.startsWith('-') && text.toDouble() == 0) text.remove(0, 1);  // nothing has no sign
  widths_[number] = std::max(widths_[number], static_cast<int>(text.size()));
  return text.rightJustified(widths_[number], QChar(0x2007));  // a space as wide as a digit
}

void TransportBar::refresh() {
  if (!instant_) {
    widths_ = {};
    for (auto* label : {time_, place_, motion_}) label->clear();
    return forgetCause();
  }
  const auto length = display_unit(Quantity::length, unit_);
  const auto speed = display_unit(Quantity::speed, unit_);
  const auto acceleration = display_unit(Quantity::acceleration, unit_);
  const int decimals = decimals_of(Quantity::length, 3, unit_);
  const auto& p = instant_->position;
  time_->setText(QString("t %1 s   %2").arg(steady(kTime, instant_->time, 3), block_name_));
  QString place;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) place += "   ";
    place += QLatin1Char(kAxisNames[static_cast<std::size_t>(axis)]) + QString(" ") +
             steady(kPlace, p[axis] * length.factor, decimals);
  }
  place += " " + length.text;
  for (std::size_t i = 0; i < turned_.size(); ++i) {
    if (!turned_[i]) continue;
    const double degrees = p[static_cast<Eigen::Index>(3 + i)] / kRadiansPerDegree;
    place += QString("   %1 %2°").arg(QLatin1Char(kAxisNames[3 + i])).arg(steady(kPlace, degrees, decimals));
  }
  place_->setText(place);
  motion_->setText(
      QString("v %1 %2   a %3 %4")
          .arg(steady(kSpeed, instant_->state.speed * speed.factor, decimals_of(Quantity::speed, 2, unit_)), speed.text,
               steady(kAcceleration, instant_->state.acceleration * acceleration.factor,
                      decimals_of(Quantity::acceleration, 0, unit_)),
               acceleration.text));
  fit();
  instant_->cause ? showCause(*instant_->cause) : forgetCause();
}

/// Where there is no room for all, what the plots tell, too, makes way: no figure is cut.
void TransportBar::fit() {
  motion_->show();
  layout()->activate();
  if (layout()->minimumSize().width() > width()) motion_->hide();
}

void TransportBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void TransportBar::setRotaryAxes(const std::array<bool, 3>& turned) {
  turned_ = turned;
  refresh();
}

void TransportBar::setPlaying(bool playing) {
  playing_ = playing;
  play_->setProperty("icon_name", playing ? "pause" : "play");
  play_->setIcon(icon(playing ? "pause" : "play", theme_));
  retranslate();
}

void TransportBar::setBusy(bool busy) {
  if (busy) {
    if (progress_->isHidden() && !patience_.isActive()) (setProgress(0), patience_.start());
    return;
  }
  patience_.stop();
  showBusy(false);
}

void TransportBar::showBusy(bool busy) {
  for (auto* widget : std::initializer_list<QWidget*>{busy_, progress_, cancel_}) widget->setVisible(busy);
}

void TransportBar::setTask(const QString& text) { busy_->setText(text); }

void TransportBar::setProgress(double fraction) { progress_->setValue(static_cast<int>(fraction * 100)); }

/// With a patch of the colour that stands for it in the ribbon.
void TransportBar::showCause(Cause cause) {
  const QColor colour = cause_colour(cause, theme_.dark ? Ground::dark : Ground::light);
  setMessage(cause_title(cause));
  message_->setTextFormat(Qt::RichText);
  message_->setText(QString("<span style='color:%1'>■</span>&nbsp; %2").arg(colour.name(), cause_title(cause)));
}

/// Where nothing is planned, nothing holds anything down.
void TransportBar::forgetCause() {
  if (message_->textFormat() == Qt::RichText) setMessage({});
}

void TransportBar::setMessage(const QString& text) {
  message_->setTextFormat(Qt::PlainText);
  message_->setText(text);
  message_->setToolTip(text);
}

void TransportBar::setUnits(Units unit) {
  unit_ = unit;
  widths_ = {};
  refresh();
}

void TransportBar::setTheme(const Theme& theme) {
  theme_ = theme;
  for (auto* button : {first_, previous_, play_, next_, last_, cancel_}) {
    button->setIcon(icon(button->property("icon_name").toString(), theme));
  }
}

void TransportBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    refresh();
  }
  QWidget::changeEvent(event);
}

void TransportBar::retranslate() {
  const auto name = [](QWidget* widget, const QString& text, const QString& key = {}) {
    name_control(widget, text, key.isEmpty() ? text : text + "  (" + key + ")");
  };
  name(first_, tr("To the start"), "Home");
  name(previous_, tr("One line back"), "←");
  name(play_, playing_ ? tr("Pause") : tr("Play"), tr("Space"));
  name(next_, tr("One line on"), "→");
  name(last_, tr("To the end"), "End");
  name(rate_, tr("Playback speed"));
  name(cancel_, tr("Cancel"), "Esc");
  progress_->setAccessibleName(tr("Progress"));
}

}  // namespace toolpace::ui
