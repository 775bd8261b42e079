#include "plots/cursor_layer.h"

namespace toolpace::ui {

CursorLayer::CursorLayer(QCustomPlot* plot, const QString& layer) : QCPLayerable(plot, layer) {}

QRectF CursorLayer::area() const {
  const auto rects = mParentPlot->axisRects();
  if (rects.isEmpty()) return {};
  return QRectF(rects.first()->rect()).united(QRectF(rects.last()->rect()));
}

double CursorLayer::xOf(double at) const {
  const auto rects = mParentPlot->axisRects();
  return rects.isEmpty() ? 0.0 : rects.first()->axis(QCPAxis::atBottom)->coordToPixel(at);
}

void CursorLayer::applyDefaultAntialiasingHint(QCPPainter* painter) const {
  applyAntialiasingHint(painter, true, QCP::aeOther);
}

void CursorLayer::draw(QCPPainter* painter) {
  const QRectF box = area();
  if (box.isEmpty()) return;
  drawMeasures(painter, box);
  if (!time) return;
  const double x = xOf(*time);
  if (x < box.left() - 1 || x > box.right() + 1) return;
  painter->setPen(QPen(theme.accent, 1.4));
  painter->drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
  for (const auto& mark : marks) {
    const double y = mark.axis->coordToPixel(mark.value);
    if (!std::isfinite(y) || !QRectF(mark.axis->axisRect()->rect()).adjusted(-1, -1, 1, 1).contains(x, y)) continue;
    painter->setPen(QPen(theme.surface, 1.5));
    painter->setBrush(mark.colour);
    painter->drawEllipse(QPointF(x, y), 4, 4);
  }
}

void CursorLayer::drawMeasures(QCPPainter* painter, const QRectF& box) const {
  if (measures[0] && measures[1]) {
    QColor tint = theme.text;
    tint.setAlphaF(0.06f);
    const double a = qBound(box.left(), xOf(*measures[0]), box.right());
    const double b = qBound(box.left(), xOf(*measures[1]), box.right());
    painter->fillRect(QRectF(QPointF(qMin(a, b), box.top()), QPointF(qMax(a, b), box.bottom())), tint);
  }
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (!measures[i]) continue;
    const double x = xOf(*measures[i]);
    if (x < box.left() - 1 || x > box.right() + 1) continue;
    painter->setPen(QPen(theme.text, 1, Qt::DashLine));
    painter->drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
    const QRectF flag(x - 8, box.top() + 1, 16, 15);
    painter->setPen(Qt::NoPen);
    painter->setBrush(theme.text);
    painter->drawRoundedRect(flag, 3, 3);
    painter->setPen(theme.surface);
    painter->drawText(flag, Qt::AlignCenter, QString::number(i + 1));
  }
}

}  // namespace toolpace::ui
