/// How high the motion plots reach: what is visible, what of it cuts, or what a person holds.

#include <algorithm>
#include <cmath>

#include "plots/profile_plot_curves.h"

namespace toolpace::ui {
namespace {

void add_values(Extent& extent, const Curve& curve) {
  for (const double value : curve.value) {
    if (std::isfinite(value)) extent.add(static_cast<float>(value));
  }
}

}  // namespace

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
  for (const Curve* curve : {&curves.error, &curves.measured}) add_values(error, *curve);
  follow_height_ = swing_height_ = {};
  for (const Curve& curve : curves.follow) add_values(follow_height_, curve);
  for (const Curve& curve : curves.swing) add_values(swing_height_, curve);
  if (whole) follow_height_ = swing_height_ = {};
  error_height_ = whole || error.is_empty() ? std::nullopt : std::optional<double>(error.high);
}

void ProfilePlot::showScales() {
  // An axis turns round, and on curves it may do more than the path does.
  const bool any_axis = std::any_of(shown_.begin(), shown_.end(), [](bool shown) { return shown; });
  const bool turns = shown_[3] || shown_[4] || shown_[5];
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].scale(heights_[i], any_axis, turns, unit_);
  error_->scale(error_height_, unit_);
  follow_->scale(follow_height_, unit_);
  swing_->scale(swing_height_, unit_);
  // The numbers at the axes were chosen before this picture's curves were there.
  for (QCPAxisRect* rect : axisRects()) rect->update(QCPLayoutElement::upPreparation);
}

}  // namespace toolpace::ui
