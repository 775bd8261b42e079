#pragma once
/// The pictures of a report, as SVG text.

#include <array>
#include <string>
#include <vector>

#include "toolpace/sample/setpoints.h"

namespace toolpace {

/// The least and the largest value of each of a fixed number of stretches of time: what a plot of that width shows.
class Envelope {
 public:
  explicit Envelope(std::size_t rows);
  void add(std::size_t row, double value);
  std::size_t bins() const { return low_.size(); }
  double low(std::size_t bin) const { return low_[bin]; }
  double high(std::size_t bin) const { return high_[bin]; }

 private:
  std::size_t rows_;
  std::vector<double> low_, high_;
};

struct PlotText {
  std::string title;  ///< such as "speed"
  std::string unit;   ///< such as "mm/s"
};

/// A curve over time. @param duration [s]
std::string plot_svg(const Envelope& curve, double duration, const PlotText& text);

/// The contour, thinned as it comes: what is kept is about an eighth of a pixel off, or more where that
/// is too much for a page.
class ContourPicture {
 public:
  /// @param extent   [mm] > 0, largest side of the box around it
  /// @param fastest  [mm/s] where the colours end
  ContourPicture(double extent, double fastest);
  void add(const std::array<double, 3>& point, double speed);

  /// The view along one axis: horizontal and vertical axis as indices of X Y Z. Empty if nothing is to be seen there.
  std::string svg(std::size_t horizontal, std::size_t vertical) const;

 private:
  struct Point {
    std::array<double, 3> at;
    double speed;
  };
  std::size_t colour(double speed) const;
  bool may_skip(const Point& point) const;
  void thin();

  double tolerance_, fastest_;
  std::vector<Point> points_;             ///< the last one is not settled yet
  std::array<double, 3> direction_ = {};  ///< of the stretch that the last one ends; a unit vector
  double reached_ = 0.0;                  ///< along it [mm]
};

}  // namespace toolpace
