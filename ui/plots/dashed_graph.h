#pragma once
/// A curve that stays dashed, and quick to draw, however many of its points share a pixel.

#include <qcustomplot.h>

namespace toolpace::ui {

/// Where its points are few, dashes run along the curve, as the pen has them. Where they are many, such dashes could not be told
/// apart, and cost the square of the points: there they run along the time, and stay where they are as the plot is moved.
class DashedGraph : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& lines) const override;

 private:
  /// The parts of a polyline that lie in dashes of `pattern` [px: on, off, on, …] along x.
  QVector<QLineF> dashes(const QVector<QPointF>& lines, const QList<qreal>& pattern) const;
};

}  // namespace toolpace::ui
