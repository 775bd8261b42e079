#pragma once
/// Relaxed logarithmic barrier of a limit.

namespace toolpace::tube {

/// B(r) = −log(1 − r²) for a use r ≥ 0 of a limit, continued as a parabola beyond `edge`, so that a motion which breaks
/// a limit has a value and a way back.
/// @source Hauser and Saccon 2006, "A barrier function method for the optimization of trajectory functionals with constraints"
struct Barrier {
  explicit Barrier(double edge_) : edge(edge_) {
    const double y = 1 - edge * edge;
    slope = 2 * edge / y;
    bend = (2 + 2 * edge * edge) / (y * y);
  }
  double edge;   ///< 0 … 1
  double slope;  ///< B′(edge)
  double bend;   ///< B″(edge)

  /// B′(r)/r, finite at r = 0.
  double slope_by_use(double r) const {
    if (r <= edge) return 2 / (1 - r * r);
    return (slope + bend * (r - edge)) / r;
  }
  /// B″(r).
  double curvature(double r) const {
    if (r > edge) return bend;
    const double y = 1 - r * r;
    return (2 + 2 * r * r) / (y * y);
  }
};

}  // namespace toolpace::tube
