#pragma once
/// Least squares of the drive model to what an axis did.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "toolpace/limits/servo_axis.h"

namespace toolpace::detail {

/// What is fitted. Those that scale (gain, frequencies, dampings) count by their logarithm.
enum FitParameter : int {
  kGain,
  kVelocityForward,
  kAccelerationForward,
  kBandwidth,
  kDamping,
  kBacklash,
  kResonance,
  kResonanceDamping,
  kZero,   ///< constant offset of the trace [mm, rad]
  kClock,  ///< what is to be added to the times of the trace [s]
  kFitParameters
};
using FitVector = Eigen::Matrix<double, kFitParameters, 1>;

/// Commanded and measured. Sizes of time and actual agree.
struct FitData {
  std::vector<double> commanded;  ///< a row a period; the axis rests before the first and after the last
  double period = 0.001;          ///< [s]
  std::vector<double> time;       ///< of each measured row, rising; 0 at the first commanded one [s]
  std::vector<double> actual;
  double finest = 1e-6;  ///< [mm, rad] no trace is finer: what is left below it tells nothing more of the drive

  /// Squared, of a row, where such squares are left.
  double noise_of(double squares) const {
    return std::max(squares / static_cast<double>(time.size()), finest * finest);
  }
};

/// [Hz] half of the trace's rows a second
double nyquist_of(const FitData& data);

/// Parameters, and which of them are free; the others stay as they are. A drive without backlash or resonance has 0 there.
struct FitState {
  ServoAxis axis;
  double zero = 0, clock = 0;
  std::array<bool, kFitParameters> free = {};
  std::optional<double> clock_error = {};  ///< [s] how well the clock is known beforehand: it is held near 0 by that

  FitVector values() const;
  /// @return false where the model has no such drive (unstable, beyond all ranges)
  bool set(const FitVector& values);
};

struct FitResult {
  FitState state;
  double squares = 0;  ///< of all residuals
  FitVector error;     ///< standard errors of values(), for independent noise of the size that is left; 0 where fixed
  double noise = 0;  ///< [mm, rad] standard deviation of what is left; errors are told as if it were `finest` at least
  double correlation = 1;  ///< ≥ 1: how much wider errors are, as what is left is no independent noise
  bool has_converged = false;
};

class ServoFit {
 public:
  explicit ServoFit(const FitData& data) : data_(data) {}

  const FitData& data() const { return data_; }

  /// The actual positions that a drive would have given, at the measured times.
  std::vector<double> model(const FitState& state) const;
  /// actual − model
  Eigen::VectorXd residuals(const FitState& state) const;
  /// Of the model, a column a parameter; of those that are not free 0.
  Eigen::MatrixXd jacobian(const FitState& state) const;

  /// Levenberg-Marquardt from a state on, until a step would take off no more than the noise hides; at most `rounds` Jacobians.
  /// Feed-forwards stay between 0 and 1, backlash above 0 and the drive's bandwidth below half of the trace's rate.
  /// @source Marquardt 1963, with Nielsen's damping (Madsen, Nielsen, Tingleff, "Methods for non-linear least squares", 2004)
  FitResult fit(FitState begin, int rounds) const;
  /// Errors, noise and its correlation at a state.
  void judge(FitResult& result) const;

 private:
  double squares_of(const FitState& state, Eigen::VectorXd& residual) const;
  const FitData& data_;
};

}  // namespace toolpace::detail
