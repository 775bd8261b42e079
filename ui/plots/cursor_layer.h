#pragma once
/// The cursor and the two measuring cursors over all stacked plots, on a layer of their own so that they move without
/// the curves being drawn again.

#include <qcustomplot.h>

#include <array>
#include <optional>

#include "theme/theme.h"

namespace toolpace::ui {

class CursorLayer : public QCPLayerable {
  Q_OBJECT

 public:
  /// A value marked on one plot where the cursor crosses its curve.
  struct Mark {
    const QCPAxis* axis;
    double value;  ///< in the axis' coordinates
    QColor colour;
  };

  CursorLayer(QCustomPlot* plot, const QString& layer);

  std::optional<double> time;
  std::array<std::optional<double>, 2> measures;
  std::vector<Mark> marks;
  Theme theme = light_theme();

  /// From the top of the first plot to the bottom of the last.
  QRectF area() const;
  double xOf(double at) const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  void drawMeasures(QCPPainter* painter, const QRectF& area) const;
};

}  // namespace toolpace::ui
