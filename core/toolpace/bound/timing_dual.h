#pragma once
/// What every timing of a known path between two rests takes at least: the dual problem of the fastest timing.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace::detail {

/// Rows that limit a motion: the axes that move, and the path itself.
inline constexpr std::size_t kMostRows = kAxisCount + 1;

/// A motion at one instant.
struct TimingSample {
  std::array<double, kMostRows> first, second;  ///< each row's derivatives by time
  double fastest;                               ///< (any motion's speed there as a multiple of this one's)², at most
};

/// Limits of the rows; may be infinite.
struct TimingLimits {
  std::size_t rows = 0;
  std::array<double, kMostRows> acceleration{}, jerk{};
};

/// Gauss points in one cell, as shares of it, and their weights.
inline constexpr std::array<double, 4> kCellPlaces = {0.06943184420297371, 0.33000947820757187, 0.6699905217924281,
                                                      0.9305681557970263};
inline constexpr std::array<double, 4> kCellWeights = {0.17392742256872692, 0.3260725774312731, 0.3260725774312731,
                                                       0.17392742256872692};

/// Any motion p(u(t)) along the path of a known one, p(u), has b = u̇² > 0 and takes ∫ du/√b, while each row keeps
///   |p″·b + p′·b′/2| ≤ A,   √b·|p‴·b + 3/2·p″·b′ + 1/2·p′·b″| ≤ J.
/// With functions μ and λ of u for each row, multiplied, added and integrated by parts (p′ and p″ vanish at rests),
///   T ≥ ∫ min over b of ((1 − Σ J|λ|)/√b + c·b) − Σ A|μ| du,   c = Σ ½·(p′·ν′ − p″·ν),   ν = λ′ − μ,
/// for any μ, and any λ with Σ J|λ| < 1, which is maximised here: λ quadratic, μ linear splines on the cells, by Newton's steps
/// with a logarithmic barrier. Whatever the steps come to, the value holds.
class TimingDual {
 public:
  /// @param cell   length of a cell [s]
  /// @param samples  of the known motion at the Gauss points of each cell
  /// @param joints  cells in which a curve ends: λ is zero there, for p″ jumps
  TimingDual(double cell, std::vector<TimingSample> samples, const TimingLimits& limits,
             const std::vector<std::size_t>& joints);

  /// Lower bound of the time [s].
  double maximise();

 private:
  struct Value {
    double bound, barrier;  ///< barrier: −∞ outside
  };
  std::size_t unknowns() const { return (cells_ + 2) * group_; }
  Value value(const std::vector<double>& x, double weight) const;
  void assemble(const std::vector<double>& x, double weight);
  bool solve();
  template <class F>
  void for_each_term(std::size_t cell, std::size_t place, F&& f) const;

  double cell_;
  std::size_t cells_, group_;  ///< group: unknowns of one spline index
  std::vector<TimingSample> samples_;
  TimingLimits limits_;
  std::vector<char> is_closed_;  ///< of each λ: overlaps a joint
  std::vector<char> is_used_;    ///< of each unknown
  std::vector<double> gradient_, step_, band_;
};

}  // namespace toolpace::detail
