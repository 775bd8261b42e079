#pragma once
/// What the colours of the preview mean: a scale with unit, least and greatest value and the value under the cursor, or
/// the names of what held the speed down. Stands under the picture, never over it.

#include <QWidget>

#include "preview/contour_canvas.h"

namespace toolpace::ui {

class ContourLegend : public QWidget {
  Q_OBJECT

 public:
  explicit ContourLegend(const ContourCanvas& canvas, QWidget* parent = nullptr);

  /// The scene, its colours or the value under the cursor changed.
  void refresh();

  QSize sizeHint() const override { return {320, heightFor(320)}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Entry {
    QString title;
    QColor colour;
    QRectF area;
  };
  bool isCategorical() const;
  int heightFor(int width) const;
  std::vector<Entry> entries(double width) const;
  void drawScale(QPainter& painter) const;
  void drawTicks(QPainter& painter, const QRectF& bar, const Interval& shown) const;
  void drawEntries(QPainter& painter) const;
  std::optional<double> hoveredValue() const;

  const ContourCanvas& canvas_;
  std::vector<bool> present_;  // causes that occur in the plan
};

/// "speed", "acceleration", … translated.
QString colour_by_title(ColourBy by);

}  // namespace toolpace::ui
