#pragma once
/// Stacked plots of speed, acceleration and jerk over one time axis.

#include <qcustomplot.h>

#include <array>
#include <memory>
#include <optional>

#include "models/units.h"
#include "plots/cursor_layer.h"

#include "plots/plot_row.h"
#include "plots/swing_row.h"

namespace toolpace::ui {

inline constexpr const char* kCursorLayer = "cursor";

class ProfilePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit ProfilePlot(QWidget* parent = nullptr);

  void setSeries(std::shared_ptr<const ProfileSeries> series);
  void setGhost(std::shared_ptr<const ProfileSeries> series);
  void setTheme(const Theme& theme);
  void setUnit(Units unit);
  /// Heights that are held stay when another time is looked at, and whatever becomes of the plan; else they fit what is visible.
  void setHeightsHeld(bool held);
  bool areHeightsHeld() const { return held_; }
  /// Heights fit what cuts; rapids, many times quicker, leave the picture.
  void setHeightsOfCutting(bool cutting);
  void setAxisShown(std::size_t axis, bool shown);  ///< X … C
  void showReadyAxes();                             ///< curves of axes that were being made are there
  void setErrorShown(bool shown);                   ///< the contour error as a fourth plot
  /// What it shows; null = not known yet.
  void setErrorTrace(std::shared_ptr<const ErrorTrace> trace);
  /// What a scope recorded; null = nothing. Its contour error is dashed beside the simulated one.
  void setMeasured(const std::shared_ptr<const MeasuredTrace>& trace);
  void setVibration(const std::shared_ptr<const VibrationTrace>& trace);
  void setVibrationShown(bool shown);  ///< how far axes with modes swing, as a plot of its own
  void setFollowShown(bool shown);     ///< the following error of its axes as a plot of its own
  void retranslate();

  void setRange(double begin, double end);  ///< [s]; kept inside the plan
  QCPRange range() const { return time_axes_.front()->range(); }
  void fit();
  void zoom(double factor, double around);  ///< [s]

  void setCursorTime(std::optional<double> time);
  void setMeasures(std::optional<double> first, std::optional<double> second);
  const std::array<std::optional<double>, 2>& measures() const { return cursor_->measures; }

  double xOf(double time) const { return time_axes_.front()->coordToPixel(time); }  ///< [px]
  /// Left and right edge of the plots [px].
  std::pair<double, double> edges() const;

 signals:
  void rangeChanged(double begin, double end);
  void timeClicked(double time);
  void measured(double first, double second);
  void laidOut();
  void heightsHeld(bool held);

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showRows();
  void layOut();
  void dress();
  struct Curves;
  void fitHeights(const Curves& curves, const TimeWindow& window);
  bool fitCutting(const Curves& curves, const TimeWindow& window);
  QString wordOf(std::size_t track) const;
  void showScales();
  Extent wholeHeight(std::size_t track) const;
  void refill();  // the curves are gathered before the next picture
  void gather();
  void updateMarks();
  double shareOf(std::size_t axis, std::size_t track) const;
  bool isWhole() const;  // all of the time is visible
  bool isAxisDrawn(std::size_t axis) const;
  double timeAt(double x) const;
  std::optional<std::size_t> measureAt(double x) const;
  double duration() const;

  std::vector<MotionRow> rows_;  // of kMotionTracks
  std::unique_ptr<ErrorRow> error_;
  std::unique_ptr<SwingRow> follow_, swing_;
  QCPItemText* time_title_ = nullptr;
  std::vector<QCPAxis*> time_axes_;  // of the rows, then of the errors
  CursorLayer* cursor_;
  std::shared_ptr<const ProfileSeries> series_, ghost_;
  std::array<bool, kPlottedAxes> shown_ = {};
  Theme theme_ = light_theme();
  Units unit_;
  bool stale_ = true;
  bool held_ = false, of_cutting_ = false;
  OfTracks<Extent> heights_;             // that are shown, in core units
  std::optional<double> error_height_;   // [mm]
  Extent follow_height_, swing_height_;  // [mm]

  QPointF pressed_at_;
  double pressed_begin_ = 0;
  bool dragging_ = false;
  std::optional<std::size_t> dragged_measure_;
};

}  // namespace toolpace::ui
