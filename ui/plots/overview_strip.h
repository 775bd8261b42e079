#pragma once
/// The speed over the whole program in miniature, with the visible window; drag the window or its edges.

#include <QPixmap>

#include "plots/time_strip.h"

namespace toolpace::ui {

class OverviewStrip : public TimeStrip {
  Q_OBJECT

 public:
  explicit OverviewStrip(QWidget* parent = nullptr);

  void setRange(double begin, double end);  ///< [s] visible
  void setCursorTime(std::optional<double> time);
  /// A plan beside the one that is drawn lasts so long [s]; 0 = there is none.
  void setOtherDuration(double duration);

  double xOf(double time) const;  ///< [px] of a time, as in the plots where they show the whole program

  QSize sizeHint() const override { return {300, 36}; }

 signals:
  void rangeRequested(double begin, double end);

 protected:
  void refresh() override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  enum class Grip { none, window, left, right };

  double duration() const;
  double first() const { return -kTimeMargin * duration(); }
  double span() const { return (1 + 2 * kTimeMargin) * duration(); }
  double timeAt(double x) const { return first() + (x - left_) / std::max(right_ - left_, 1.0) * span(); }
  Grip gripAt(double x) const;
  void drawMiniature();

  double begin_ = 0, end_ = 1, other_ = 0;
  std::optional<double> cursor_;
  QPixmap miniature_;
  Grip grip_ = Grip::none;
  double grip_offset_ = 0;  // from the window's begin to the mouse [s]
};

}  // namespace toolpace::ui
