#pragma once
/// The stacked plots one by one: what each shows, how it is scaled and dressed.

#include <qcustomplot.h>

#include <array>

#include "drawing/profile_curves.h"
#include "drawing/sample_series.h"
#include "models/units.h"
#include "theme/theme.h"
#include "toolpace/base/axes.h"

namespace toolpace::ui {

inline constexpr std::size_t kPlottedAxes = kAxisCount;  // X … C

/// How the curve of an axis is drawn.
QPen axis_pen(std::size_t axis, const Theme& theme);
/// What a scope recorded is dashed.
QPen measured_pen(const Theme& theme);

/// One of kMotionTracks along the path, with its caps, plan B behind it and axes on demand.
class MotionRow {
 public:
  /// Adds a rectangle and its graphs to the plot; the plot owns them.
  MotionRow(QCustomPlot* plot, std::size_t track);

  QCPAxisRect* rect() const { return rect_; }
  std::size_t track() const { return track_; }
  QCPAxis* value() const { return rect_->axis(QCPAxis::atLeft); }
  QCPAxis* time() const { return rect_->axis(QCPAxis::atBottom); }
  double factor() const { return factor_; }  ///< from core units to the numbers of the axis

  void dress(const Theme& theme, const QFont& font);
  /// Makes `extent` fill the height. @param both_ways  axes are shown, which turn round @param turns  rotary ones, too: their
  /// numbers are degrees on the same scale
  void scale(Extent extent, bool both_ways, bool turns, Units unit);
  void showOwn(const MotionCurves& curves, bool dense);
  void showOther(const MotionEnvelope& sides);
  void showCaps(const CapCurves& caps);
  void showAxis(std::size_t axis, const MotionCurves& curves);
  /// In place of a curve that has no values; empty: none.
  void showWord(const QString& word);

 private:
  void fill(QCPGraph* graph, const Curve& curve) const;

  std::size_t track_;
  QCPAxisRect* rect_;
  QCPGraph *feed_, *cap_high_, *cap_low_, *ghost_, *ghost_low_, *curve_;
  std::array<QCPGraph*, kPlottedAxes> axis_ = {};
  QCPItemText* word_;
  double factor_ = 1;
};

/// The contour error of a simulation, and dashed that of a measured trace. Not in the layout until somebody asks for it.
class ErrorRow {
 public:
  explicit ErrorRow(QCustomPlot* plot);

  QCPAxisRect* rect() const { return rect_; }
  QCPAxis* value() const { return rect_->axis(QCPAxis::atLeft); }
  QCPAxis* time() const { return rect_->axis(QCPAxis::atBottom); }
  bool isShown() const { return rect_->visible(); }
  void setShown(bool shown);
  void setTrace(std::shared_ptr<const ErrorTrace> trace) { error_ = SampleSeries(std::move(trace)); }
  void setMeasured(std::shared_ptr<const ErrorTrace> trace) { measured_ = SampleSeries(std::move(trace)); }
  void dress(const Theme& theme, const QFont& font);
  /// @param largest  that fills the height [mm]; nothing = the largest of the trace
  void scale(std::optional<double> largest, Units units);
  /// Nothing where it is not shown.
  Curve curve(const TimeWindow& window) const;
  Curve measured(const TimeWindow& window) const;
  void show(const Curve& curve, const Curve& measured);
  /// Height of the curve at a time, in the numbers of the axis; nothing where it is not shown.
  std::optional<double> heightAt(double time) const;

 private:
  QCPAxisRect* rect_;
  QCPGraph *curve_, *measured_curve_;
  SampleSeries error_{nullptr}, measured_{nullptr};
  double factor_ = 1000;  // contour errors are micrometres; in inches they are thousandths
};

}  // namespace toolpace::ui
