#include "plots/profile_plot.h"

#include <algorithm>
#include <cmath>

#include "plots/profile_plot_curves.h"
#include "plots/time_strip.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastSpan = 1e-7;                // of the plan
constexpr std::size_t kMostBlocksAtOnce = 20'000;  // whose axes are looked through while a picture is made

}  // namespace

ProfilePlot::ProfilePlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName("profilePlot");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
  setNoAntialiasingOnDrag(false);
  setNotAntialiasedElements(QCP::aeAll);
  setAntialiasedElements(QCP::aePlottables | QCP::aeOther);
  plotLayout()->clear();
  plotLayout()->setRowSpacing(0);
  plotLayout()->setMargins(QMargins(0, 4, 0, 0));
  for (std::size_t i = 0; i < kMotionTrackCount; ++i) rows_.emplace_back(this, i);
  time_title_ = new QCPItemText(this);
  time_title_->position->setType(QCPItemPosition::ptAbsolute);
  time_title_->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_title_->setClipToAxisRect(false);
  addLayer(kCursorLayer, layer("overlay"), QCustomPlot::limBelow);
  layer(kCursorLayer)->setMode(QCPLayer::lmBuffered);
  cursor_ = new CursorLayer(this, kCursorLayer);
  error_ = std::make_unique<ErrorRow>(this);
  follow_ = std::make_unique<SwingRow>(this, 1, "f");
  swing_ = std::make_unique<SwingRow>(this, 2, "d");
  showRows();
  for (const auto& row : rows_) time_axes_.push_back(row.time());
  time_axes_.push_back(error_->time());
  for (const auto* row : {follow_.get(), swing_.get()}) time_axes_.push_back(row->time());
  // However much changes before the next picture, the curves are gathered once, when their width is known.
  connect(this, &QCustomPlot::afterLayout, this, [this] {
    emit laidOut();
    gather();
  });
  layOut();
  retranslate();
  dress();
}

void ProfilePlot::setErrorShown(bool shown) {
  error_->setShown(shown);
  showRows();
  layOut();
  refill();
}

void ProfilePlot::setFollowShown(bool shown) {
  follow_->setShown(shown);
  showRows();
  layOut();
  refill();
}

void ProfilePlot::setVibrationShown(bool shown) {
  swing_->setShown(shown);
  showRows();
  layOut();
  refill();
}

void ProfilePlot::setVibration(const std::shared_ptr<const VibrationTrace>& trace) {
  swing_->setVibration(trace);
  refill();
}

void ProfilePlot::setMeasured(const std::shared_ptr<const MeasuredTrace>& trace) {
  error_->setMeasured(trace ? trace->actual : nullptr);
  follow_->setFollowing(trace);
  refill();
}

/// Below those that are always there, the ones that somebody asked for.
void ProfilePlot::showRows() {
  auto* layout = plotLayout();
  std::vector<QCPAxisRect*> shown;
  for (QCPAxisRect* rect : {error_->rect(), follow_->rect(), swing_->rect()}) {
    if (rect->layout()) layout->take(rect);
    if (rect->visible()) shown.push_back(rect);
  }
  layout->simplify();
  for (QCPAxisRect* rect : shown) layout->addElement(layout->rowCount(), 0, rect);
}

void ProfilePlot::setErrorTrace(std::shared_ptr<const ErrorTrace> trace) {
  error_->setTrace(std::move(trace));
  refill();
}

void ProfilePlot::setTheme(const Theme& theme) {
  theme_ = theme;
  dress();
}

void ProfilePlot::setUnit(Units unit) {
  unit_ = unit;
  showScales();
  refill();
}

void ProfilePlot::retranslate() { time_title_->setText(tr("t  s")); }

void ProfilePlot::dress() {
  setBackground(theme_.surface);
  cursor_->theme = theme_;
  for (auto& row : rows_) row.dress(theme_, font());
  error_->dress(theme_, font());
  follow_->dress(theme_, font());
  swing_->dress(theme_, font());
  time_title_->setColor(theme_.secondary);
  time_title_->setFont(font());
  refill();
}

/// Of the longer plan.
double ProfilePlot::duration() const {
  double longest = 0;
  for (const auto* s : {series_.get(), ghost_.get()}) longest = std::max(longest, s ? s->duration() : 0.0);
  return longest > 0 ? longest : 1.0;
}

void ProfilePlot::setSeries(std::shared_ptr<const ProfileSeries> series) {
  const bool whole = !series_ || series_->is_empty() || isWhole();
  series_ = std::move(series);
  whole ? fit() : setRange(range().lower, range().upper);
  refill();
}

void ProfilePlot::setGhost(std::shared_ptr<const ProfileSeries> series) {
  if (!ghost_ && !series) return;
  const bool whole = isWhole();
  ghost_ = std::move(series);
  whole ? fit() : setRange(range().lower, range().upper);
  refill();
}

void ProfilePlot::setAxisShown(std::size_t axis, bool shown) {
  shown_.at(axis) = shown;
  showReadyAxes();
}

void ProfilePlot::showReadyAxes() { refill(); }

/// Of long programs only what a worker has made ready.
bool ProfilePlot::isAxisDrawn(std::size_t axis) const {
  return shown_[axis] && series_ && !series_->is_empty() &&
         (series_->is_axis_made(axis) || series_->blocks.size() <= kMostBlocksAtOnce);
}

bool ProfilePlot::isWhole() const { return range().lower <= 0 && range().upper >= duration(); }

void ProfilePlot::setRange(double begin, double end) {
  const double total = duration(), least = std::max(total * kLeastSpan, 1e-9);
  const double margin = total * kTimeMargin;
  double width = std::clamp(end - begin, least, total + 2 * margin);
  if (!std::isfinite(width) || !std::isfinite(begin)) return;
  const double low = std::clamp(begin, -margin, std::max(total + margin - width, -margin));
  for (auto* axis : time_axes_) axis->setRange(low, low + width);
  refill();
  emit rangeChanged(low, low + width);
}

void ProfilePlot::fit() {
  const double total = duration();
  setRange(-kTimeMargin * total, (1 + kTimeMargin) * total);
}

void ProfilePlot::zoom(double factor, double around) {
  const QCPRange now = range();
  const double width = now.size() / factor, share = (around - now.lower) / now.size();
  setRange(around - width * share, around + width * (1 - share));
}

void ProfilePlot::refill() {
  stale_ = true;
  replot(rpQueuedReplot);
}

void ProfilePlot::gather() {
  if (!stale_) return;
  stale_ = false;
  const QCPRange now = range();
  const TimeWindow window{now.lower, now.upper,
                          std::max(static_cast<int>(rows_[0].rect()->width() * bufferDevicePixelRatio()), 16)};
  Curves curves;
  if (series_) curves.own = motion_curves(*series_, window);
  if (ghost_) curves.other = motion_envelope(*ghost_, window);
  for (std::size_t axis = 0; axis < shown_.size(); ++axis) {
    if (!isAxisDrawn(axis)) continue;
    curves.axes[axis] = axis_curves(*series_, window, axis);
    for (std::size_t track = 0; is_rotary(axis) && track < kMotionTrackCount; ++track) {
      for (double& value : curves.axes[axis][track].value) value *= shareOf(axis, track);
    }
  }
  curves.error = error_->curve(window);
  curves.measured = error_->measured(window);
  curves.follow = follow_->curves(window);
  curves.swing = swing_->curves(window);
  if (series_ && series_->is_jerk_unbounded()) curves.own[kJerkTrack] = {};
  if (ghost_ && ghost_->is_jerk_unbounded()) curves.other.high[kJerkTrack] = curves.other.low[kJerkTrack] = {};
  fitHeights(curves, window);
  showScales();
  const bool dense = series_ && is_dense(*series_, window);
  const CapCurves caps = series_ ? cap_curves(*series_, window) : CapCurves{};
  for (auto& row : rows_) {
    row.showOwn(curves.own, dense);
    row.showOther(curves.other);
    row.showCaps(caps);
    row.showWord(wordOf(row.track()));
    for (std::size_t axis = 0; axis < shown_.size(); ++axis) row.showAxis(axis, curves.axes[axis]);
  }
  error_->show(curves.error, curves.measured);
  follow_->show(curves.follow);
  swing_->show(curves.swing);
  updateMarks();
}

void ProfilePlot::updateMarks() {
  cursor_->marks.clear();
  if (!cursor_->time || !series_ || series_->is_empty()) return;
  const PhaseState s = series_->state_at(*cursor_->time);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i == kJerkTrack && series_->is_jerk_unbounded()) continue;
    cursor_->marks.push_back({rows_[i].value(), kMotionTracks[i].value(s) * rows_[i].factor(), theme_.accent});
  }
  if (const auto height = error_->heightAt(*cursor_->time)) {
    cursor_->marks.push_back({error_->value(), *height, theme_.error});
  }
}

void ProfilePlot::setCursorTime(std::optional<double> time) {
  cursor_->time = time;
  updateMarks();
  layer(kCursorLayer)->replot();
}

void ProfilePlot::setMeasures(std::optional<double> first, std::optional<double> second) {
  cursor_->measures = {first, second};
  layer(kCursorLayer)->replot();
}

std::pair<double, double> ProfilePlot::edges() const {
  return {rows_[0].rect()->left(), rows_[0].rect()->right() + 1.0};
}

/// All plots equally high, the last one with the numbers of the time axis below it, their title where the titles of the
/// strips stand.
void ProfilePlot::layOut() {
  const QFontMetrics metrics(font());
  const int line = metrics.height(), left = metrics.horizontalAdvance("-0000") + 2 * line + 16, below = line + 6;
  const auto rects = axisRects();
  const double each = std::max((height() - below - 2.0) / static_cast<double>(rects.size()), 20.0);
  QList<double> shares;
  for (qsizetype i = 0; i < rects.size(); ++i) {
    const bool last = i + 1 == rects.size();
    rects[i]->setMargins(QMargins(left, i == 0 ? 2 : 6, 12, last ? below : 2));
    rects[i]->axis(QCPAxis::atBottom)->setTickLabels(last);
    rects[i]
        ->axis(QCPAxis::atLeft)
        ->ticker()
        ->setTickCount(std::clamp(static_cast<int>((each - 8) / (line * 1.4)), 2, 5));
    shares.append(last ? each + below : each);
  }
  plotLayout()->setRowStretchFactors(shares);
  time_title_->position->setCoords(left - 30.0, height() - below / 2.0 - 1);
}

void ProfilePlot::resizeEvent(QResizeEvent* event) {
  layOut();
  QCustomPlot::resizeEvent(event);
  refill();
}

}  // namespace toolpace::ui
