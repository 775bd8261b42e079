#pragma once
/// Points at many path lengths of one piece of a spline.

#include <array>
#include <cstddef>

#include "toolpace/path/spline.h"

namespace toolpace {

/// A piece of a spline, made ready for many points on it: its own polynomials, and the length as a polynomial of the parameter.
/// Costs as much as a few points by parameter_at(); each point then a tenth of that. What it answers does not depend on what
/// was asked before. Keeps a reference to the curve.
class PieceWalker {
 public:
  /// @param length  piece_length() of the piece
  PieceWalker(const SplineCurve& curve, const SplinePiece& piece, double length);

  /// Whether the length is a polynomial to 1e-13 of itself. Elsewhere (cusps) parameter_at() is what there is.
  bool is_exact() const { return is_exact_; }

  /// Point at path length `s` of the piece, 0 ≤ s ≤ length, as spline_point() at parameter_at(): 1e-13 of the length.
  /// @pre is_exact()
  AxisVector point_at(double s) const;

 private:
  static constexpr std::size_t kMostTerms = 17;  // of the length

  void find_terms();
  bool find_length(double length);
  void find_guess(double length);
  double speed_at(double x) const;
  double place_at(double s) const;

  const SplineCurve* curve_;
  double middle_, half_;                   // of the parameter u = middle + half·x, −1 ≤ x ≤ 1
  std::array<Eigen::Vector4d, 10> terms_;  // of the homogeneous curve by x
  std::array<double, kMostTerms> length_;  // of the path length from the piece's beginning by x
  std::size_t degree_ = 0;                 // of the length
  std::array<double, 6> guess_;            // of x by the length: Newton's form on both ends and the middle, each twice
  double middle_length_ = 0, whole_ = 0;
  bool is_exact_ = false;
};

}  // namespace toolpace
