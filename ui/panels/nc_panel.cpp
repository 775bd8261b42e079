#include "panels/nc_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include "models/block_name.h"
#include "theme/control_name.h"

namespace toolpace::ui {

NcPanel::NcPanel(QWidget* parent)
    : QWidget(parent),
      change_bar_(new ChangeBar("changeBar", this)),
      view_(new NcView(this)),
      key_(new LineKey("gutterKey", this)),
      modal_(new ModalStrip(this)),
      bar_(new QWidget(this)),
      text_(new QLineEdit(bar_)),
      none_(new QLabel(bar_)),
      hint_(new QLabel(this)) {
  times_ = new QLabel(this);
  times_->setObjectName("timesLabel");
  times_->setProperty("role", "secondary");
  times_->setContentsMargins(8, 0, 8, 1);
  setObjectName("ncPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout(bar_);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(text_, 1);
  row->addWidget(none_);
  text_->setObjectName("findEdit");
  text_->setClearButtonEnabled(true);
  text_->installEventFilter(this);
  none_->setProperty("role", "error");
  none_->hide();
  bar_->hide();
  column->addWidget(change_bar_);
  column->addWidget(bar_);
  column->addWidget(view_, 1);
  auto* key_row = new QHBoxLayout;
  key_row->setContentsMargins(8, 1, 8, 1);
  key_row->addWidget(key_);
  key_row->addStretch(1);
  column->addLayout(key_row);
  column->addWidget(times_);
  column->addWidget(modal_);
  hint_->setObjectName("dropHint");
  hint_->setProperty("role", "hint");
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setContentsMargins(8, 8, 8, 8);
  hint_->hide();
  column->addWidget(hint_);
  setFocusProxy(view_);
  connect(view_, &NcView::currentLineChanged, this, &NcPanel::showModal);
  connect(view_, &NcView::findRequested, this, &NcPanel::openFindBar);
  connect(text_, &QLineEdit::textChanged, this, [this] { none_->hide(); });
  retranslate();
}

void NcPanel::showPlans(const Planned& plan, const Planned&) {
  if (plan.timeline == timeline_) return;
  timeline_ = plan.timeline;
  fillKey();
  showTimes();
  view_->setTimeline(plan.timeline, plan ? plan.scene->range(ColourBy::speed).high : 0);
}

void NcPanel::showController(const ControllerView& view) {
  if (view.found == found_) return;
  found_ = view.found;
  showTimes();
}

void NcPanel::setTimesShown(bool shown) {
  has_times_ = shown;
  showTimes();
}

void NcPanel::showTimes() {
  using Times = std::shared_ptr<const std::vector<double>>;
  view_->setTimes(has_times_, found_ ? Times(found_, &found_->line_time) : Times());
  times_->setVisible(has_times_ && timeline_);
  const auto title = found_ ? controller_title(found_->prediction.controller) : std::string_view();
  times_->setText(found_
                      ? tr("times: s on %1").arg(QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())))
                      : tr("times: s"));
}

void NcPanel::setUnits(Units unit) { view_->setUnit(unit); }

void NcPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  view_->setTheme(theme);
  fillKey();
  modal_->setTheme(theme);
}

void NcPanel::setColourMap(ColourMap map) {
  view_->setColourMap(map);
  fillKey();
}

void NcPanel::fillKey() {
  QLinearGradient speeds(0, 0, 1, 0);
  speeds.setCoordinateMode(QGradient::ObjectMode);
  for (const int level : {0, 64, 128, 192, 255}) {
    speeds.setColorAt(level / 255.0, QColor(view_->colours()[static_cast<std::size_t>(level)]));
  }
  key_->setTextColour(theme_.secondary);
  key_->setSamples({{tr("mean speed"), {}, speeds}, {tr("time lost"), {}, NcView::lossColour(theme_)}});
  name_control(key_, tr("Bars beside the lines"),
               tr("Colour: mean speed of the line, as in the preview; bar: how much longer it takes than at its feed"));
  key_->setVisible(timeline_ != nullptr);
}

void NcPanel::showModal(int line) {
  const auto& document = view_->document();
  modal_->setSnapshot(document ? document->reading->modal.at(static_cast<std::size_t>(line)) : std::nullopt);
}

void NcPanel::openFindBar() { openBar(Bar::find); }
void NcPanel::openGoToBar() { openBar(Bar::go_to); }

void NcPanel::openBar(Bar bar) {
  asked_[static_cast<std::size_t>(asks_)] = text_->text();
  asks_ = bar;
  text_->setText(asked_[static_cast<std::size_t>(bar)]);
  retranslate();
  bar_->show();
  text_->setFocus();
  text_->selectAll();
}

void NcPanel::setHintVisible(bool visible) { hint_->setVisible(visible); }

void NcPanel::find(bool backwards) { none_->setVisible(!view_->findNext(text_->text(), backwards)); }

void NcPanel::goTo() {
  const auto& document = view_->document();
  const auto place = document ? place_named(*document, text_->text()) : std::nullopt;
  none_->setVisible(!place);
  if (!place) return;
  place->line ? emit lineRequested(static_cast<int>(*place->line)) : emit timeRequested(*place->time);
}

bool NcPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != text_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
    asks_ == Bar::find ? find(key->modifiers() & Qt::ShiftModifier) : goTo();
    return true;
  }
  if (key->key() == Qt::Key_Escape) {
    bar_->hide();
    view_->setFocus();
    return true;
  }
  return false;
}

void NcPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void NcPanel::retranslate() {
  const bool finds = asks_ == Bar::find;
  text_->setPlaceholderText(finds ? tr("Find") : tr("120, N120 or 12.5 s"));
  text_->setAccessibleName(finds ? tr("Find in program") : tr("Go to a line, a block number or a time"));
  none_->setText(tr("not found"));
  view_->setAccessibleName(tr("NC program"));
  hint_->setText(tr("drop an NC program here"));
  fillKey();
  showTimes();
  view_->setEmptyHint(tr("drop an NC program here"));
}

}  // namespace toolpace::ui
