#include "plots/dashed_graph.h"

#include <cmath>
#include <numeric>

namespace toolpace::ui {
namespace {

constexpr int kPixelsOfFewPoints = 4;  // the least from one to the next, on average

}  // namespace

void DashedGraph::drawLinePlot(QCPPainter* painter, const QVector<QPointF>& lines) const {
  const QPen pen = painter->pen();
  QList<qreal> pattern = pen.dashPattern();
  const bool is_dense = lines.size() * kPixelsOfFewPoints > keyAxis()->axisRect()->width();
  if (pattern.isEmpty() || !is_dense || painter->modes().testFlag(QCPPainter::pmVectorized)) {
    return QCPGraph::drawLinePlot(painter, lines);
  }
  for (qreal& length : pattern) length *= std::max(1.0, pen.widthF());  // which a pen counts in
  painter->setPen(QPen(pen.brush(), pen.widthF()));
  painter->drawLines(dashes(lines, pattern));
}

QVector<QLineF> DashedGraph::dashes(const QVector<QPointF>& lines, const QList<qreal>& pattern) const {
  const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0), origin = keyAxis()->coordToPixel(0);
  const QCPAxisRect& seen = *keyAxis()->axisRect();
  QVector<QLineF> drawn;
  drawn.reserve(lines.size());
  for (qsizetype k = 1; k < lines.size(); ++k) {
    const QPointF a = lines[k - 1], b = lines[k];
    if (!(b.x() >= a.x()) || std::isnan(a.y() + b.y())) continue;  // a gap
    const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0;
    // Dash by dash from a on; `part` counts dashes and what is between them.
    const double first = std::max<double>(a.x(), seen.left()), last = std::min<double>(b.x(), seen.right());
    double begin = std::floor((first - origin) / period) * period + origin;
    for (qsizetype part = 0; begin <= last; ++part) {
      const double end = begin + pattern[part % pattern.size()];
      const double from = std::max(begin, a.x()), to = std::min(end, b.x());
      const bool is_whole = from == a.x() && to == b.x();
      if (part % 2 == 0 && from <= to && end > a.x()) {
        drawn.push_back(is_whole ? QLineF(a, b)
                                 : QLineF(from, a.y() + slope * (from - a.x()), to, a.y() + slope * (to - a.x())));
      }
      begin = end;
    }
  }
  return drawn;
}

}  // namespace toolpace::ui
