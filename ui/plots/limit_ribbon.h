#pragma once
/// The binding-limit ribbon: every instant of the visible time says what holds the speed down. Where several causes
/// share a pixel, they share its height in proportion to their time.

#include "plots/time_strip.h"

namespace toolpace::ui {

class LimitRibbon : public TimeStrip {
  Q_OBJECT

 public:
  explicit LimitRibbon(QWidget* parent = nullptr);

  void setRange(double begin, double end);  ///< [s] visible
  void paintInto(QPainter& painter, const QRectF& area, double begin, double end) const;

  double xOf(double time) const;  ///< [px] of a time, as in the plots

  QSize sizeHint() const override { return {300, 18}; }

 signals:
  void timeClicked(double time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  double timeAt(double x) const;
  QString description(double time, double pixel) const;

  double begin_ = 0, end_ = 1;
};

}  // namespace toolpace::ui
