#pragma once
/// Radial error over the angle of a circle, enlarged about the commanded circle.

#include <QPainterPath>
#include <QWidget>
#include <optional>

#include "drawing/circularity.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

class PolarPlot : public QWidget {
  Q_OBJECT

 public:
  explicit PolarPlot(QWidget* parent = nullptr);

  void setRoundness(std::shared_ptr<const Roundness> roundness);
  void setEnlargement(std::optional<double> factor);  ///< nothing = as the errors ask for
  void setCursorTime(std::optional<double> time);     ///< [s]
  void setUnit(Units unit);
  void setTheme(const Theme& theme);
  void setEmptyHint(const QString& text);

  /// How much the error is enlarged against the circle as it is drawn.
  double enlargement() const;
  /// Where a point of the curve stands.
  QPointF position(const Roundness::Point& point) const;

  QSize sizeHint() const override { return {260, 220}; }
  QSize minimumSizeHint() const override { return {120, 100}; }

 signals:
  void timeClicked(double time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  double circleRadius() const;  ///< of the commanded circle [px]
  double pixelsPerMm() const;   ///< of the error
  void drawRings(QPainter& painter) const;
  void drawCurve(QPainter& painter) const;
  QPainterPath curve(std::size_t from, std::size_t to) const;  ///< of the points from … to
  void drawMarks(QPainter& painter) const;

  std::shared_ptr<const Roundness> roundness_;
  std::optional<double> factor_, cursor_;
  Units unit_;
  Theme theme_ = light_theme();
  QString empty_hint_;
};

}  // namespace toolpace::ui
