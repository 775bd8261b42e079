#include "plots/profile_plot.h"

#include <algorithm>
#include <cmath>

#include "plots/time_strip.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastSpan = 1e-7;                // of the plan
constexpr std::size_t kMostBlocksAtOnce = 20'000;  // whose axes are looked through while a picture is made

void add_values(Extent& extent, const Curve& curve) {
  for (const double value : curve.value) {
    if (std::isfinite(value)) extent.add(static_cast<float>(value));
  }
}

}  // namespace

/// What is drawn of the visible time.
struct ProfilePlot::Curves {
  MotionCurves own;
  MotionEnvelope other;
  std::array<MotionCurves, kPlottedAxes> axes;
  Curve error;
};

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
  for (const auto& row : rows_) time_axes_.push_back(row.time());
  time_axes_.push_back(error_->time());
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
  layOut();
  refill();
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
  if (whole) fit();
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

void ProfilePlot::setHeightsHeld(bool held) {
  if (held_ == held) return;
  held_ = held;
  emit heightsHeld(held);
  refill();
}

/// Rotary axes are read in degrees on the scale of the path: by what their values are multiplied to be drawn there.
double ProfilePlot::shareOf(std::size_t axis, std::size_t track) const {
  const Quantity quantity = kMotionTracks[track].quantity;
  return is_rotary(axis) ? display_unit(rotary(quantity), unit_).factor / display_unit(quantity, unit_).factor : 1.0;
}

/// The zero line is always in it.
Extent ProfilePlot::wholeHeight(std::size_t track) const {
  Extent extent;
  extent.add(0.0f);
  for (const auto* s : {series_.get(), ghost_.get()}) {
    if (s && !s->is_empty()) extent.add(s->whole[track]);
  }
  for (std::size_t axis = 0; axis < shown_.size(); ++axis) {
    if (!isAxisDrawn(axis)) continue;
    const Extent whole = axis_whole(*series_, axis)[track];
    if (whole.is_empty()) continue;
    const auto share = static_cast<float>(shareOf(axis, track));
    extent.add({whole.low * share, whole.high * share});
  }
  return extent;
}

void ProfilePlot::setHeightsOfCutting(bool cutting) {
  of_cutting_ = cutting;
  refill();
}

/// False where nothing cuts in the window.
bool ProfilePlot::fitCutting(const Curves& curves, const TimeWindow& window) {
  MotionExtent cutting;
  for (const auto* s : {series_.get(), ghost_.get()}) {
    if (s) cutting.add(cutting_extent(*s, window));
  }
  if (cutting[kSpeedTrack].is_empty()) return false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    cutting[i].add(0.0f);
    for (const auto& axis : curves.axes) {
      for (qsizetype k = 0; k < axis[i].time.size(); ++k) {
        const double value = axis[i].value[k];
        if (std::isfinite(value) && is_cutting(*series_->outcome, axis[i].time[k]))
          cutting[i].add(static_cast<float>(value));
      }
    }
    heights_[i] = cutting[i];
  }
  return true;
}

/// What stands where a curve would be wrong.
QString ProfilePlot::wordOf(std::size_t track) const {
  if (track != kJerkTrack) return {};
  if (series_ && series_->is_jerk_unbounded()) return tr("jerk is not bounded: acceleration changes in steps");
  return ghost_ && ghost_->is_jerk_unbounded() ? tr("B: jerk is not bounded") : QString();
}

// Where all of the time is visible the plan decides; where a part of it is, what is drawn of it.
void ProfilePlot::fitHeights(const Curves& curves, const TimeWindow& window) {
  if (held_) return;
  const bool fits_cutting = of_cutting_ && fitCutting(curves, window);
  const bool whole = isWhole();
  for (std::size_t i = 0; i < rows_.size() && !fits_cutting; ++i) {
    Extent extent;
    extent.add(0.0f);
    for (const auto* side : {&curves.own, &curves.other.high, &curves.other.low}) add_values(extent, (*side)[i]);
    for (const auto& axis : curves.axes) add_values(extent, axis[i]);
    heights_[i] = whole || !(extent.high > extent.low) ? wholeHeight(i) : extent;
  }
  Extent error;
  add_values(error, curves.error);
  error_height_ = whole || error.is_empty() ? std::nullopt : std::optional<double>(error.high);
}

void ProfilePlot::showScales() {
  // An axis turns round, and on curves it may do more than the path does.
  const bool any_axis = std::any_of(shown_.begin(), shown_.end(), [](bool shown) { return shown; });
  const bool turns = shown_[3] || shown_[4] || shown_[5];
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].scale(heights_[i], any_axis, turns, unit_);
  error_->scale(error_height_, unit_);
  // The numbers at the axes were chosen before this picture's curves were there.
  for (QCPAxisRect* rect : axisRects()) rect->update(QCPLayoutElement::upPreparation);
}

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
  error_->show(curves.error);
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
