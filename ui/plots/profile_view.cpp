#include "plots/profile_view.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>

#include "plots/limit_ribbon.h"
#include "plots/overview_strip.h"
#include "plots/profile_plot.h"
#include "plots/value_table.h"
#include "theme/control_name.h"
#include "theme/flow_layout.h"
#include "theme/line_key.h"

namespace toolpace::ui {
namespace {

constexpr int kRoomForErrors = 300;  // px, for two more plots

}  // namespace
ProfileView::ProfileView(QWidget* parent) : QWidget(parent) {
  setObjectName("profileView");
  pages_ = new QStackedWidget(this);
  plot_ = new ProfilePlot(pages_);
  pages_->addWidget(plot_);
  buildTable();
  ribbon_ = new LimitRibbon(this);
  overview_ = new OverviewStrip(this);
  buildHeader();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(pages_, 1);
  column->addWidget(ribbon_);
  column->addWidget(overview_);
  connect(plot_, &ProfilePlot::timeClicked, this, &ProfileView::cursorTimeRequested);
  connect(ribbon_, &LimitRibbon::timeClicked, this, &ProfileView::cursorTimeRequested);
  connect(overview_, &OverviewStrip::rangeRequested, this, &ProfileView::setVisibleRange);
  connect(plot_, &ProfilePlot::laidOut, this, &ProfileView::alignStrips);
  connect(plot_, &ProfilePlot::measured, this, &ProfileView::updateReadout);
  connect(plot_, &ProfilePlot::rangeChanged, this, [this](double begin, double end) {
    ribbon_->setRange(begin, end);
    overview_->setRange(begin, end);
    values_->setRange(begin, end);
    emit visibleRangeChanged(begin, end);
  });
  retranslate();
  updateReadout();
}

void ProfileView::buildTable() {
  values_ = new ValueTable(this);
  table_ = new QTableView(pages_);
  table_->setObjectName("profileTable");
  table_->setModel(values_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  pages_->addWidget(table_);
  connect(table_, &QTableView::activated, this,
          [this](const QModelIndex& index) { emit cursorTimeRequested(values_->timeOf(index.row())); });
}

void ProfileView::setTableShown(bool shown) {
  show_table_->setChecked(shown);
  pages_->setCurrentIndex(shown ? 1 : 0);
}

void ProfileView::setErrorTrace(std::shared_ptr<const ErrorTrace> trace) { plot_->setErrorTrace(std::move(trace)); }

void ProfileView::setErrorShown(bool shown) {
  show_error_->setChecked(shown);
  plot_->setErrorShown(shown);
}

void ProfileView::setFollowShown(bool shown) {
  show_follow_->setChecked(shown);
  plot_->setFollowShown(shown);
}

void ProfileView::setVibrationShown(bool shown) {
  show_vibration_->setChecked(shown);
  plot_->setVibrationShown(shown);
}

void ProfileView::setVibration(const std::shared_ptr<const VibrationTrace>& trace) {
  plot_->setVibration(trace);
  show_vibration_->setVisible(trace != nullptr);
  if (!trace) setVibrationShown(false);
}

/// A trace shows itself when it comes, and takes its plot along when it goes.
void ProfileView::showTrace(const std::shared_ptr<const MeasuredTrace>& trace) {
  plot_->setMeasured(trace);
  const bool is_there = trace != nullptr;
  if (is_there == has_trace_) return;
  has_trace_ = is_there;
  show_follow_->setVisible(is_there);
  setFollowShown(is_there);
  if (is_there && plot_->height() >= kRoomForErrors) setErrorShown(true);
  fillKey();
}

void ProfileView::buildHeader() {
  header_ = new QWidget(this);
  auto* row = new FlowLayout(header_);
  row->setContentsMargins(8, 2, 8, 2);
  row->setSpacing(8);
  const auto button = [&](const char* name, bool checkable) {
    auto* b = new QToolButton(header_);
    b->setObjectName(name);
    b->setCheckable(checkable);
    b->setAutoRaise(true);
    b->setIconSize({16, 16});
    row->addWidget(b);
    return b;
  };
  constexpr std::array names = {"showAxisX", "showAxisY", "showAxisZ", "showAxisA", "showAxisB", "showAxisC"};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    axes_[i] = button(names[i], true);
    axes_[i]->setText(QString(QLatin1Char(kAxisNames[i])));
    axes_[i]->setVisible(!is_rotary(i));
    connect(axes_[i], &QToolButton::toggled, this, [this, i](bool on) {
      plot_->setAxisShown(i, on);
      ShownAxes shown;
      for (std::size_t k = 0; k < axes_.size(); ++k) shown[k] = axes_[k]->isChecked();
      emit axesShown(shown);
    });
  }
  measure_ = button("measure", true);
  fit_ = button("fitTime", false);
  show_error_ = button("showError", true);
  show_follow_ = button("showFollow", true);
  show_follow_->hide();
  show_vibration_ = button("showVibration", true);
  show_vibration_->hide();
  show_table_ = button("showTable", true);
  key_ = new LineKey("profileKey", header_);
  row->addWidget(key_);
  readout_ = new QLabel(header_);
  readout_->setObjectName("profileReadout");
  readout_->setTextFormat(Qt::PlainText);
  readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(readout_);
  connect(measure_, &QToolButton::toggled, this, &ProfileView::setMeasuring);
  connect(fit_, &QToolButton::clicked, this, &ProfileView::fit);
  connect(show_error_, &QToolButton::toggled, this, &ProfileView::setErrorShown);
  connect(show_follow_, &QToolButton::toggled, this, &ProfileView::setFollowShown);
  connect(show_vibration_, &QToolButton::toggled, this, &ProfileView::setVibrationShown);
  connect(show_table_, &QToolButton::toggled, this, &ProfileView::setTableShown);
}

void ProfileView::retranslate() {
  setAccessibleName(tr("Motion"));
  plot_->setAccessibleName(tr("Speed, acceleration and jerk over time"));
  ribbon_->setAccessibleName(tr("What holds the speed down over time"));
  overview_->setAccessibleName(tr("Speed over the whole program, with the visible time"));
  readout_->setAccessibleName(tr("Values at the cursor"));
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    name_control(axes_[i], tr("Show axis %1").arg(axes_[i]->text()));
  }
  measure_->setText(tr("Measure"));
  name_control(measure_, tr("Measure"), tr("Two cursors with their differences (M)"));
  fit_->setText(tr("Fit"));
  name_control(fit_, tr("Fit time"), tr("Show the whole program"));
  show_error_->setText(tr("Error"));
  name_control(show_error_, tr("Contour error"), tr("Contour error of the simulated drives as a fourth plot"));
  show_follow_->setText(tr("Following"));
  name_control(show_follow_, tr("Following error"),
               tr("Following error of each axis of the trace as a plot of its own"));
  show_vibration_->setText(tr("Vibration"));
  name_control(show_vibration_, tr("Vibration"), tr("How far each axis with modes swings, as a plot of its own"));
  show_table_->setText(tr("Table"));
  name_control(show_table_, tr("Table"), tr("The visible values as a table; Ctrl+C copies them"));
  table_->setAccessibleName(tr("Visible values"));
  plot_->retranslate();
  plot_->replot(QCustomPlot::rpQueuedReplot);
  ribbon_->update();
  overview_->update();
  fillKey();
}

void ProfileView::fillKey() {
  QPen cap(theme_.secondary, 1);
  cap.setDashPattern({6, 4});
  QColor feed = theme_.secondary;
  feed.setAlphaF(0.4f);
  std::vector<KeySample> samples = {
      {QStringLiteral("A"), QPen(theme_.accent, 1.6)}, {tr("allowed"), cap}, {tr("feed"), QPen(feed, 2)}};
  if (has_ghost_) samples.push_back({QStringLiteral("B"), QPen(theme_.plan_b, 1.3, Qt::DashLine)});
  if (has_trace_) samples.push_back({tr("measured"), measured_pen(theme_)});
  key_->setTextColour(theme_.secondary);
  key_->setSamples(std::move(samples));
  name_control(key_, tr("Lines of the plots"),
               tr("A: this plan, B: the one that is pinned. Dashed grey: what feed, machine and curves allow in each "
                  "block; pale: the "
                  "programmed feed"));
}

void ProfileView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    updateReadout();
  }
  QWidget::changeEvent(event);
}

void ProfileView::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return QApplication::clipboard()->setText(values_->text());
  if (event->key() == Qt::Key_M && event->modifiers() == Qt::NoModifier) return measure_->toggle();
  QWidget::keyPressEvent(event);
}

void ProfileView::setSeries(std::shared_ptr<const ProfileSeries> series) {
  series_ = series;
  ribbon_->setSeries(series);
  overview_->setSeries(series);
  values_->setSeries(series);
  plot_->setSeries(std::move(series));
  updateReadout();
}

void ProfileView::setGhost(std::shared_ptr<const ProfileSeries> series) {
  has_ghost_ = series != nullptr;
  fillKey();
  overview_->setOtherDuration(series ? series->duration() : 0.0);
  plot_->setGhost(std::move(series));
}

void ProfileView::setTheme(const Theme& theme) {
  theme_ = theme;
  fillKey();
  plot_->setTheme(theme);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const QString colour = axis_pen(i, theme).color().name();
    axes_[i]->setStyleSheet(QString("QToolButton { color: %1; font-weight: bold; }").arg(colour));
  }
  ribbon_->setTheme(theme);
  overview_->setTheme(theme);
}

void ProfileView::showPlans(const Planned& plan, const Planned& pinned) {
  if (plan.series != series_) setSeries(plan.series);
  setErrorTrace(plan.proof ? plan.proof->scene->trace : nullptr);
  setVibration(plan.proof ? plan.proof->vibration : nullptr);
  setGhost(pinned.series);
}

void ProfileView::showInstant(const std::optional<Instant>& instant) {
  setCursorTime(instant ? std::optional(instant->time) : std::nullopt);
}

void ProfileView::setUnits(Units unit) {
  unit_ = unit;
  plot_->setUnit(unit);
  values_->setUnit(unit);
  updateReadout();
}

void ProfileView::setCursorTime(std::optional<double> time) {
  cursor_ = time;
  plot_->setCursorTime(time);
  overview_->setCursorTime(time);
  updateReadout();
}

void ProfileView::setVisibleRange(double begin, double end) { plot_->setRange(begin, end); }
void ProfileView::fit() { plot_->fit(); }

std::pair<double, double> ProfileView::visibleRange() const { return {plot_->range().lower, plot_->range().upper}; }

std::optional<double> ProfileView::timeAt(const QPoint& at) const {
  const QPoint inside = plot_->mapFrom(this, at);
  const auto [left, right] = plot_->edges();
  if (!series_ || series_->is_empty() || pages_->currentIndex() != 0 || !plot_->rect().contains(inside)) return {};
  if (inside.x() < left || inside.x() > right || right <= left) return {};
  const auto [begin, end] = visibleRange();
  return std::clamp(begin + (inside.x() - left) / (right - left) * (end - begin), 0.0, series_->duration());
}

void ProfileView::setRotaryAxes(const std::array<bool, 3>& there) {
  if (there == rotary_) return;
  rotary_ = there;
  for (std::size_t i = 0; i < there.size(); ++i) {
    axes_[3 + i]->setVisible(there[i]);
    if (!there[i]) axes_[3 + i]->setChecked(false);
  }
  updateReadout();
}

void ProfileView::showReadyAxes() { plot_->showReadyAxes(); }

void ProfileView::setAxisShown(std::size_t axis, bool shown) { axes_.at(axis)->setChecked(shown); }

bool ProfileView::isMeasuring() const { return measure_->isChecked(); }

void ProfileView::setMeasuring(bool on) {
  measure_->setChecked(on);
  if (on && !plot_->measures()[0]) {
    const auto [begin, end] = visibleRange();
    plot_->setMeasures(begin + (end - begin) / 3, begin + (end - begin) * 2 / 3);
  } else if (!on) {
    plot_->setMeasures({}, {});
  }
  updateReadout();
  emit measuringChanged(on);
}

QString ProfileView::measureText() const {
  const auto& at = plot_->measures();
  if (!at[0] || !at[1] || !series_ || series_->is_empty()) return {};
  const PhaseState a = series_->state_at(*at[0]), b = series_->state_at(*at[1]);
  return QString("Δt %1   Δv %2   Δs %3")
      .arg(steadyText(*at[1] - *at[0], Quantity::time, 4), steadyText(b.speed - a.speed, Quantity::speed, 2),
           steadyText(b.distance - a.distance, Quantity::length, 3));
}

QString ProfileView::steadyText(double core_value, Quantity quantity, int decimals) const {
  const DisplayUnit unit = display_unit(quantity, unit_);
  return QString::number(core_value * unit.factor, 'f', decimals_of(quantity, decimals, unit_)) + ' ' + unit.text;
}

void ProfileView::updateReadout() {
  QString text = measureText();
  if (text.isEmpty() && cursor_ && series_ && !series_->is_empty()) {
    const PhaseState s = series_->state_at(*cursor_);
    text = "t " + steadyText(*cursor_, Quantity::time, 3);
    for (const MotionTrack& track : kMotionTracks) {
      text += QString("   %1 %2").arg(track.symbol, steadyText(track.value(s), track.quantity, track.read_decimals));
    }
  }
  readout_->setText(text);
}

void ProfileView::alignStrips() {
  const auto [left, right] = plot_->edges();
  ribbon_->setEdges(left, right);
  overview_->setEdges(left, right);
}

}  // namespace toolpace::ui
