#include "plots/axis_look.h"

#include <qcustomplot.h>

namespace toolpace::ui {
namespace {

constexpr int kDigits = 6;

}  // namespace

void dressAxis(QCPAxis& axis, const Theme& theme, const QFont& font) {
  axis.setBasePen(QPen(theme.line));
  axis.setTickPen(QPen(theme.line));
  axis.setSubTicks(false);
  axis.setTickLength(0, 3);
  axis.setTickLabelColor(theme.secondary);
  axis.setLabelColor(theme.secondary);
  axis.setTickLabelFont(font);
  axis.setLabelFont(font);
  axis.setNumberFormat("gbc");
  axis.setNumberPrecision(kDigits);
  axis.grid()->setPen(QPen(theme.line, 1, Qt::DotLine));
}

}  // namespace toolpace::ui
