#pragma once
/// Lines straight into the pixels of an image: plain and fast while something moves, smooth at rest.

#include <QImage>
#include <cstdint>

namespace toolpace::ui {

/// Draws into a QImage of format RGB32. Coordinates are pixels of the image, (0, 0) its upper left corner; anything,
/// however far outside, may be passed: lines are clipped first. Not finite: ignored.
class LineRaster {
 public:
  /// @param width  of the lines [px], ≥ 1
  LineRaster(QImage& image, double width, bool smooth);

  void draw(double x0, double y0, double x1, double y1, QRgb colour);

  /// Dashes of `on` px and gaps of `off` px. `phase` [px] is where in the pattern the line begins; returns where it
  /// ends.
  double draw_dashed(double x0, double y0, double x1, double y1, QRgb colour, double on, double off, double phase);

 private:
  struct Ends {
    double x0, y0, x1, y1;
  };
  bool clip(Ends& ends) const;
  void draw_plain(const Ends& ends, QRgb colour);
  void draw_smooth(const Ends& ends, QRgb colour);
  void blend(int x, int y, QRgb colour, int alpha);

  QRgb* pixels_;
  int stride_, columns_, rows_;
  double width_;
  bool smooth_;
};

}  // namespace toolpace::ui
