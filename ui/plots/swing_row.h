#pragma once
/// How far each axis is off at each time: from what was commanded, as a scope measured it; or swinging, as its modes have it.

#include <qcustomplot.h>

#include <array>
#include <memory>
#include <vector>

#include "drawing/measured_trace.h"
#include "drawing/sample_series.h"
#include "drawing/vibration_trace.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

/// Dashed, in the colours of the axes. Not in the layout until somebody asks for it.
class SwingRow {
 public:
  /// @param symbol  beside its scale
  SwingRow(QCustomPlot* plot, int index, const char* symbol);

  QCPAxisRect* rect() const { return rect_; }
  QCPAxis* value() const { return rect_->axis(QCPAxis::atLeft); }
  QCPAxis* time() const { return rect_->axis(QCPAxis::atBottom); }
  bool isShown() const { return rect_->visible(); }
  void setShown(bool shown);
  void setFollowing(const std::shared_ptr<const MeasuredTrace>& trace);
  void setVibration(const std::shared_ptr<const VibrationTrace>& trace);
  void dress(const Theme& theme, const QFont& font);
  /// @param extent  that fills the height [mm; a degree counts as one]; empty = all of the trace
  void scale(Extent extent, Units units);
  using Curves = std::array<Curve, kAxisCount>;
  /// Nothing where it is not shown.
  Curves curves(const TimeWindow& window) const;
  void show(const Curves& curves);

 private:
  using Values = std::array<std::vector<float>, kAxisCount>;
  void setValues(const std::shared_ptr<const std::vector<double>>& time, const Values* values);

  QCPAxisRect* rect_;
  QString symbol_;
  std::array<QCPGraph*, kAxisCount> curves_;
  std::array<SampleSeries, kAxisCount> offsets_;
  Extent whole_;
  double factor_ = 1000;
};

}  // namespace toolpace::ui
