#include "plots/row_parts.h"

#include <algorithm>

namespace toolpace::ui {
namespace {

constexpr int kLeastSide = 30;          // px, of a plot without its margins
constexpr int kLabelSlack = 4;          // px, that a label stays shorter than its plot is high
constexpr double kSmallestLabel = 0.7;  // of the size of other texts

}  // namespace

void fill_graph(QCPGraph* graph, const Curve& curve, double factor) {
  QVector<QCPGraphData> points(curve.time.size());
  for (qsizetype i = 0; i < curve.time.size(); ++i) points[i] = {curve.time[i], curve.value[i] * factor};
  graph->data()->set(points, true);
}

void set_row_label(QCPAxis& axis, const QString& label) {
  axis.setLabel(label);
  QFont font = axis.tickLabelFont();
  int longest = 1;
  for (const QString& line : label.split('\n')) longest = std::max(longest, QFontMetrics(font).horizontalAdvance(line));
  const int room = axis.axisRect()->height() - kLabelSlack;
  font.setPointSizeF(font.pointSizeF() * std::clamp(static_cast<double>(room) / longest, kSmallestLabel, 1.0));
  axis.setLabelFont(font);
}

QCPAxisRect* new_row_rect(QCustomPlot* plot, int row) {
  auto* rect = new QCPAxisRect(plot, true);
  plot->plotLayout()->addElement(row, 0, rect);
  rect->setAutoMargins(QCP::msNone);
  rect->setMinimumSize(kLeastSide, kLeastSide);
  rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(8);
  return rect;
}

void dress_row(QCPAxisRect* rect, const Theme& theme, const QFont& font) {
  QColor faint = theme.line;
  faint.setAlphaF(0.7f);
  QCPAxis* value = rect->axis(QCPAxis::atLeft);
  for (auto* axis : {value, rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atRight), rect->axis(QCPAxis::atTop)}) {
    axis->setVisible(true);
    axis->setBasePen(QPen(theme.line, 1));
    axis->setTickPen(QPen(theme.line, 1));
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(theme.secondary);
    axis->setLabelColor(theme.text);
    axis->setTickLabelFont(font);
    axis->setLabelFont(font);
    axis->setLabelPadding(0);
    axis->setTickLabelPadding(4);
    axis->grid()->setPen(QPen(faint, 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
    axis->setTickLengthIn(0);
    axis->setTickLengthOut(axis == value ? 4 : 0);
  }
  value->grid()->setZeroLinePen(QPen(theme.secondary, 1));
  rect->axis(QCPAxis::atRight)->setTicks(false);
  rect->axis(QCPAxis::atTop)->setTicks(false);
}

}  // namespace toolpace::ui
