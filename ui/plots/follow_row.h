#pragma once
/// The following error of each axis, as a scope measured it.

#include <qcustomplot.h>

#include <array>
#include <memory>
#include <vector>

#include "drawing/measured_trace.h"
#include "drawing/sample_series.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

/// Dashed, in the colours of the axes. Not in the layout until somebody asks for it.
class FollowRow {
 public:
  explicit FollowRow(QCustomPlot* plot);

  QCPAxisRect* rect() const { return rect_; }
  QCPAxis* value() const { return rect_->axis(QCPAxis::atLeft); }
  QCPAxis* time() const { return rect_->axis(QCPAxis::atBottom); }
  bool isShown() const { return rect_->visible(); }
  void setShown(bool shown);
  void setTrace(const std::shared_ptr<const MeasuredTrace>& trace);
  void dress(const Theme& theme, const QFont& font);
  /// @param extent  that fills the height [mm; a degree counts as one]; empty = all of the trace
  void scale(Extent extent, Units units);
  using Curves = std::array<Curve, kAxisCount>;
  /// Nothing where it is not shown.
  Curves curves(const TimeWindow& window) const;
  void show(const Curves& curves);

 private:
  QCPAxisRect* rect_;
  std::array<QCPGraph*, kAxisCount> curves_;
  std::array<SampleSeries, kAxisCount> errors_;
  Extent whole_;
  double factor_ = 1000;
};

}  // namespace toolpace::ui
