#include "toolpace/servo/servo_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "toolpace/limits/machine.h"
#include "toolpace/sample/cubic_between.h"
#include "toolpace/servo/axis_servo.h"
#include "toolpace/servo/servo_range.h"

namespace toolpace::detail {
namespace {

constexpr double kLogStep = 1e-4, kShareStep = 1e-4;  // of differences for the Jacobian
constexpr double kPlayStep = 1e-6;                    // [mm, rad]
constexpr double kLeastPlay = 1e-9;                   // [mm, rad] of a model with play: none is another model
constexpr double kStable = 0.999;                     // of the gain that swings up
constexpr double kNothing = 0.01;                     // of a row's noise, squared: a tenth of a standard error
constexpr double kMostTrust = 0.02;                   // of the damping, after a step that came out as expected
constexpr double kMostDamping = 1e12;                 // beyond it no step leads on
constexpr int kMostLags = 200;                        // of the residuals' correlation

bool is_log(int p) {
  return p == kGain || p == kBandwidth || p == kDamping || p == kResonance || p == kResonanceDamping;
}

double step_of(int p, double value) {
  if (p == kBacklash) return std::min(kPlayStep, value / 2);
  return is_log(p) ? kLogStep : kShareStep;
}

bool fits(double value, const ServoRange& range) { return value >= range.least && value <= range.most; }

}  // namespace

FitVector FitState::values() const {
  FitVector v;
  v << std::log(axis.position_gain), axis.velocity_feed_forward, axis.acceleration_feed_forward,
      std::log(axis.bandwidth), std::log(axis.damping), axis.backlash,
      axis.resonance > 0 ? std::log(axis.resonance) : 0.0, std::log(axis.resonance_damping), zero, clock;
  return v;
}

bool FitState::set(const FitVector& v) {
  axis.position_gain = std::exp(v[kGain]);
  axis.velocity_feed_forward = v[kVelocityForward];
  axis.acceleration_feed_forward = v[kAccelerationForward];
  axis.bandwidth = std::exp(v[kBandwidth]);
  axis.damping = std::exp(v[kDamping]);
  if (free[kBacklash]) axis.backlash = v[kBacklash];
  if (axis.resonance > 0) axis.resonance = std::exp(v[kResonance]);
  axis.resonance_damping = std::exp(v[kResonanceDamping]);
  zero = v[kZero];
  clock = v[kClock];
  const double most = 2 * axis.damping * 2 * std::numbers::pi * axis.bandwidth;
  return v.allFinite() && axis.position_gain < kStable * most && fits(axis.position_gain, kServoGain) &&
         fits(axis.bandwidth, kServoBandwidth) && fits(axis.damping, kServoDamping) &&
         (axis.resonance == 0 || fits(axis.resonance, kServoResonance)) &&
         fits(axis.resonance_damping, kServoDamping) && (!free[kBacklash] || axis.backlash >= kLeastPlay) &&
         std::abs(axis.velocity_feed_forward) < 10 && std::abs(axis.acceleration_feed_forward) < 100;
}

double nyquist_of(const FitData& data) {
  return 0.5 * (static_cast<double>(data.time.size()) - 1) / (data.time.back() - data.time.front());
}

std::vector<double> ServoFit::model(const FitState& state) const {
  AxisServo servo = AxisServo::of(state.axis, data_.period);
  const auto& r = data_.commanded;
  servo.reset(r.front());
  // Two rows more than are needed, for the cubic there.
  const double last = std::max(0.0, (data_.time.back() + state.clock) / data_.period);
  const auto rows = static_cast<std::size_t>(last) + 3;
  std::vector<double> slide(rows);
  double before = r.front(), from = before;
  for (std::size_t k = 0; k < rows; ++k) {
    const double to = k < r.size() ? r[k] : r.back();
    slide[k] = servo.step(before, from, to);
    before = from;
    from = to;
  }
  std::vector<double> at(data_.time.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    at[i] = cubic_between(slide, (data_.time[i] + state.clock) / data_.period).value + state.zero;
  }
  return at;
}

Eigen::VectorXd ServoFit::residuals(const FitState& state) const {
  const std::vector<double> at = model(state);
  Eigen::VectorXd left(static_cast<Eigen::Index>(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i) left[static_cast<Eigen::Index>(i)] = data_.actual[i] - at[i];
  return left;
}

Eigen::MatrixXd ServoFit::jacobian(const FitState& state) const {
  const auto rows = static_cast<Eigen::Index>(data_.time.size());
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(rows, kFitParameters);
  const FitVector here = state.values();
  for (int p = 0; p < kFitParameters; ++p) {
    if (!state.free[static_cast<std::size_t>(p)]) continue;
    if (p == kZero) {
      j.col(p).setOnes();
      continue;
    }
    const double step = p == kClock ? data_.period * kShareStep : step_of(p, here[p]);
    FitState more = state, less = state;
    FitVector v = here;
    v[p] = here[p] + step;
    more.set(v);
    v[p] = here[p] - step;
    less.set(v);
    j.col(p) = (residuals(less) - residuals(more)) / (2 * step);
  }
  return j;
}

double ServoFit::squares_of(const FitState& state, Eigen::VectorXd& residual) const {
  residual = residuals(state);
  return residual.squaredNorm();
}

namespace {

/// What slow motion tells of a drive: its lag is first·ṙ + second·r̈ + …
struct Lags {
  double first, second;

  explicit Lags(const FitVector& v)
      : first((1 - v[kVelocityForward]) / std::exp(v[kGain])), second((inertia(v) - first) / std::exp(v[kGain])) {}
  /// The feed-forwards of v by its other parameters and these lags.
  void give_to(FitVector& v) const {
    v[kVelocityForward] = 1 - std::exp(v[kGain]) * first;
    v[kAccelerationForward] = 1 - (first + std::exp(v[kGain]) * second) / drive_lag(v);
  }

 private:
  static double drive_lag(const FitVector& v) { return std::exp(v[kDamping] - v[kBandwidth]) / std::numbers::pi; }
  static double inertia(const FitVector& v) { return drive_lag(v) * (1 - v[kAccelerationForward]); }
};

constexpr std::pair<double, double> range_of(int p) {
  if (p == kVelocityForward || p == kAccelerationForward) return {0.0, 1.0};
  return {p == kBacklash ? kLeastPlay : -kUnlimited, kUnlimited};
}

/// Whether a step down the gradient would leave the parameter's range.
bool is_held(int p, double value, double gradient) {
  const auto [least, most] = range_of(p);
  return (value <= least && gradient < 0) || (value >= most && gradient > 0);
}

/// Where a step of the fit begins: the normal equations of what is free, and what the clock is held by.
struct Normal {
  std::vector<int> index;  // of the free parameters
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient, scale;
  double clock_weight = 0;  // what is known of the clock is one more row, by the noise that is left

  double clock_cost(const FitVector& v) const { return clock_weight * v[kClock] * v[kClock]; }
  /// What the whole step would take off the squares, were the model linear.
  double to_gain() const { return gradient.dot(Eigen::VectorXd(matrix.ldlt().solve(gradient))); }
  /// Along the step, with the lags changing evenly: at equal lags the squares lie in a narrow, bent valley.
  FitVector moved(const FitVector& v, const Eigen::VectorXd& step) const {
    constexpr double kPart = 1e-4;
    FitVector whole = v, less = v, more = v;
    for (std::size_t i = 0; i < index.size(); ++i) {
      const double d = step[static_cast<Eigen::Index>(i)];
      whole[index[i]] += d, less[index[i]] -= kPart * d, more[index[i]] += kPart * d;
    }
    const auto has = [&](int p) { return std::find(index.begin(), index.end(), p) != index.end(); };
    if (has(kVelocityForward) && has(kAccelerationForward)) {
      Lags lags(v);
      const Lags before(less), after(more);
      lags.first += (after.first - before.first) / (2 * kPart);
      lags.second += (after.second - before.second) / (2 * kPart);
      lags.give_to(whole);
    }
    for (const int p : index) whole[p] = std::clamp(whole[p], range_of(p).first, range_of(p).second);
    return whole;
  }
};

Normal normal_at(const FitState& state, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual) {
  Normal n;
  const FitVector here = state.values(), down = jacobian.transpose() * residual;
  for (int p = 0; p < kFitParameters; ++p) {
    if (state.free[static_cast<std::size_t>(p)] && !is_held(p, here[p], down[p])) n.index.push_back(p);
  }
  if (n.index.empty()) return n;  // all are held at the ends of their ranges
  const Eigen::MatrixXd j = jacobian(Eigen::all, n.index);
  n.matrix = j.transpose() * j;
  n.gradient = j.transpose() * residual;
  if (state.clock_error) {
    n.clock_weight =
        residual.squaredNorm() / static_cast<double>(residual.size()) / (*state.clock_error * *state.clock_error);
  }
  for (std::size_t i = 0; i < n.index.size(); ++i) {
    if (n.index[i] != kClock) continue;
    const auto k = static_cast<Eigen::Index>(i);
    n.matrix(k, k) += n.clock_weight;
    n.gradient[k] -= n.clock_weight * here[kClock];
  }
  n.scale = n.matrix.diagonal().cwiseMax(1e-30 * n.matrix.diagonal().maxCoeff());
  return n;
}

}  // namespace

FitResult ServoFit::fit(FitState state, int rounds) const {
  FitResult result{state, 0, FitVector::Zero(), 0, 1, false};
  if (!state.set(state.values())) {
    result.squares = std::numeric_limits<double>::infinity();
    return result;
  }
  Eigen::VectorXd residual;
  double squares = squares_of(state, residual), damping = 1e-3, growth = 2;
  for (int round = 0; round < rounds && !result.has_converged; ++round) {
    const Normal normal = normal_at(state, jacobian(state), residual);
    result.has_converged = normal.index.empty() || normal.to_gain() <= kNothing * data_.noise_of(squares);
    for (bool has_moved = false; !has_moved && !result.has_converged;) {
      Eigen::MatrixXd damped = normal.matrix;
      damped.diagonal() += damping * normal.scale;
      const Eigen::VectorXd step = damped.ldlt().solve(normal.gradient);
      FitState trial = state;
      Eigen::VectorXd left;
      const bool exists =
          step.allFinite() && trial.set(normal.moved(state.values(), step)) && trial.axis.bandwidth < nyquist_of(data_);
      const double now = exists ? squares_of(trial, left) : std::numeric_limits<double>::infinity();
      const double gain = squares + normal.clock_cost(state.values()) - now - normal.clock_cost(trial.values());
      if (!exists || !(gain >= 0)) {
        damping *= growth;
        growth *= 2;
        result.has_converged = damping >= kMostDamping;
        continue;
      }
      const double expected = step.dot(damping * normal.scale.cwiseProduct(step) + normal.gradient);
      const double ratio = expected > 0 ? gain / expected : 0;
      damping *= std::max(kMostTrust, 1 - std::pow(2 * ratio - 1, 3));
      growth = 2;
      state = trial;
      residual = left;
      squares = now;
      has_moved = true;
    }
  }
  result.state = state;
  result.squares = squares;
  return result;
}

void ServoFit::judge(FitResult& result) const {
  std::vector<int> index;
  for (int p = 0; p < kFitParameters; ++p) {
    if (result.state.free[static_cast<std::size_t>(p)]) index.push_back(p);
  }
  const Eigen::VectorXd left = residuals(result.state);
  const auto rows = left.size();
  const double freedom = std::max<double>(1, static_cast<double>(rows) - static_cast<double>(index.size()));
  result.noise = std::sqrt(left.squaredNorm() / freedom);
  // 1 + 2Σρ up to the first lag at which the correlation is lost in its own scatter.
  double sum = 1;
  for (Eigen::Index lag = 1; lag < std::min<Eigen::Index>(kMostLags, rows / 4); ++lag) {
    const double rho = left.head(rows - lag).dot(left.tail(rows - lag)) / std::max(left.squaredNorm(), 1e-300);
    if (rho < 2 / std::sqrt(static_cast<double>(rows))) break;
    sum += 2 * rho;
  }
  result.correlation = std::sqrt(sum);
  const Eigen::MatrixXd j = jacobian(result.state)(Eigen::all, index);
  Eigen::MatrixXd normal = j.transpose() * j;
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] != kClock || !result.state.clock_error) continue;
    normal(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) +=
        std::pow(result.noise / *result.state.clock_error, 2);
  }
  // Scaled to a diagonal of ones, or parameters of different sizes cost each other's digits.
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseMax(1e-150).cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::MatrixXd inverse = scaled.completeOrthogonalDecomposition().pseudoInverse();
  result.error.setZero();
  for (std::size_t i = 0; i < index.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.error[index[i]] =
        std::max(result.noise, data_.finest) * result.correlation * std::sqrt(std::max(0.0, inverse(k, k))) * scale[k];
  }
}

}  // namespace toolpace::detail
