#include "toolpace/servo/mode.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace toolpace {
namespace {

constexpr double kShort = 1.0;      // [rad] of the mode: pieces below it are power series
constexpr int kSeriesTerms = 26;    // 1/26! is nothing beside 1
constexpr double kCritical = 1e-7;  // |1 − ζ²| below which both roots are one
constexpr int kCreepRounds = 60;

using Matrix = Eigen::Matrix<double, kAccelerationTerms, kAccelerationTerms>;

/// Chebyshev's places in 0 … 1.
std::array<double, kAccelerationTerms> chebyshev_places() {
  std::array<double, kAccelerationTerms> places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = 0.5 - 0.5 * std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / kAccelerationTerms);
  }
  return places;
}

/// From values at the places to coefficients in shares of the duration.
Matrix to_coefficients() {
  Matrix powers;
  for (int i = 0; i < powers.rows(); ++i) {
    double power = 1;
    for (int k = 0; k < powers.cols(); ++k) {
      powers(i, k) = power;
      power *= acceleration_places()[static_cast<std::size_t>(i)];
    }
  }
  return powers.inverse();
}

double value_at(const AccelerationPolynomial& c, double t) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + c[k];
  return sum;
}

double slope_at(const AccelerationPolynomial& c, double t) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 1;) sum = sum * t + static_cast<double>(k) * c[k];
  return sum;
}

}  // namespace

const std::array<double, kAccelerationTerms>& acceleration_places() {
  static const auto places = chebyshev_places();
  return places;
}

AccelerationPolynomial acceleration_through(const std::array<double, kAccelerationTerms>& values, double duration) {
  static const Matrix matrix = to_coefficients();
  const Eigen::Matrix<double, kAccelerationTerms, 1> v(values.data());
  const Eigen::Matrix<double, kAccelerationTerms, 1> c = matrix * v;
  AccelerationPolynomial out;
  double power = 1;
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = c[static_cast<Eigen::Index>(k)] / power;
    power *= duration;
  }
  return out;
}

AccelerationPolynomial acceleration_of(const Phase& phase) {
  if (phase.shape == PhaseShape::constant_jerk) return {phase.acceleration, phase.rate};
  std::array<double, kAccelerationTerms> values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = evaluate(phase, acceleration_places()[i] * phase.duration).acceleration;
  return acceleration_through(values, phase.duration);
}

namespace {

/// q with q̈ + 2ζω·q̇ + ω²·q = −a.
AccelerationPolynomial particular_of(const AccelerationPolynomial& a, double omega, double damping) {
  AccelerationPolynomial q = {};
  for (std::size_t k = q.size(); k-- > 0;) {
    const auto n = static_cast<double>(k);
    const double next = k + 1 < q.size() ? q[k + 1] : 0.0, second = k + 2 < q.size() ? q[k + 2] : 0.0;
    q[k] = -(a[k] + 2 * damping * omega * (n + 1) * next + (n + 2) * (n + 1) * second) / (omega * omega);
  }
  return q;
}

/// Without acceleration.
ModeState free_at(double omega, double damping, const ModeState& u, double t) {
  const double decay = damping * omega, rest = 1 - damping * damping;
  if (std::abs(rest) < kCritical) {
    const double e = std::exp(-decay * t), slope = u.speed + decay * u.place;
    return {e * (u.place + slope * t), e * (u.speed - decay * slope * t)};
  }
  if (rest > 0) {
    const double w = omega * std::sqrt(rest), e = std::exp(-decay * t), c = std::cos(w * t), s = std::sin(w * t);
    const double other = (u.speed + decay * u.place) / w;
    return {e * (u.place * c + other * s), e * (u.speed * c - (decay * other + w * u.place) * s)};
  }
  const double w = omega * std::sqrt(-rest), slow = -(decay - w), fast = -(decay + w);
  const double of_slow = (u.speed - fast * u.place) / (2 * w), of_fast = u.place - of_slow;
  const double a = of_slow * std::exp(slow * t), b = of_fast * std::exp(fast * t);
  return {a + b, slow * a + fast * b};
}

}  // namespace

ModePiece::ModePiece(double omega, double damping, const ModeState& begin, const AccelerationPolynomial& acceleration)
    : omega_(omega),
      damping_(damping),
      begin_(begin),
      acceleration_(acceleration),
      particular_(particular_of(acceleration, omega, damping)) {}

ModeState ModePiece::at(double t) const {
  const AccelerationPolynomial &a = acceleration_, &q = particular_;
  if (omega_ * t > kShort) {
    const ModeState free = free_at(omega_, damping_, {begin_.place - q[0], begin_.speed - q[1]}, t);
    return {value_at(q, t) + free.place, slope_at(q, t) + free.speed};
  }
  // d = Σ e[k] with e[k] = d[k]·t^k, from the differential equation itself.
  std::array<double, kSeriesTerms> e;
  e[0] = begin_.place;
  e[1] = begin_.speed * t;
  double place = e[0] + e[1], slope = e[1], power = t * t;
  for (int k = 0; k + 2 < kSeriesTerms; ++k) {
    const double of_a = k < static_cast<int>(a.size()) ? a[static_cast<std::size_t>(k)] * power : 0.0;
    power *= t;
    const double n = k;
    const auto i = static_cast<std::size_t>(k);
    e[i + 2] =
        -(of_a + 2 * damping_ * omega_ * t * (n + 1) * e[i + 1] + omega_ * omega_ * t * t * e[i]) / ((n + 2) * (n + 1));
    place += e[i + 2];
    slope += (n + 2) * e[i + 2];
  }
  return {place, t > 0 ? slope / t : begin_.speed};
}

Mode::Mode(double frequency, double damping) : omega_(2 * std::numbers::pi * frequency), damping_(damping) {}

void Mode::run(const AccelerationPolynomial& acceleration, double duration) {
  if (duration > 0) state_ = piece(acceleration).at(duration);
}

double Mode::amplitude() const {
  const auto& [place, speed] = state_;
  const double rest = 1 - damping_ * damping_;
  if (rest > kCritical) {
    return std::hypot(place, (speed + damping_ * omega_ * place) / (omega_ * std::sqrt(rest)));
  }
  // It creeps back, and is furthest off now or where it turns, which it does once at most.
  const ModePiece left = piece({});
  double low = 0, high = 2 * std::numbers::pi / omega_;
  if ((left.at(high).speed > 0) == (speed > 0)) return std::abs(place);
  for (int round = 0; round < kCreepRounds; ++round) {
    const double middle = (low + high) / 2;
    ((left.at(middle).speed > 0) == (speed > 0) ? low : high) = middle;
  }
  return std::max(std::abs(place), std::abs(left.at(low).place));
}

std::complex<double> acceleration_spectrum(std::span<const Phase> phases, double omega) {
  using Complex = std::complex<double>;
  Complex sum = 0;
  double begin = 0;
  for (const Phase& phase : phases) {
    const AccelerationPolynomial c = acceleration_of(phase);
    const double t = phase.duration, x = omega * t;
    std::array<Complex, kAccelerationTerms> integral;  // of t^k·e^(−jωt) / T^(k+1)
    if (std::abs(x) > kShort) {
      const Complex last = std::polar(1.0, -x), jx(0, x);
      integral[0] = (1.0 - last) / jx;
      for (std::size_t k = 1; k < integral.size(); ++k)
        integral[k] = (static_cast<double>(k) * integral[k - 1] - last) / jx;
    } else {
      for (std::size_t k = 0; k < integral.size(); ++k) {
        Complex term = 1;
        integral[k] = 0;
        for (int m = 0; m < kSeriesTerms; ++m) {
          integral[k] += term / (static_cast<double>(k) + m + 1.0);
          term *= Complex(0, -x) / (m + 1.0);
        }
      }
    }
    Complex part = 0;
    double power = t;
    for (std::size_t k = 0; k < integral.size(); ++k) {
      part += c[k] * power * integral[k];
      power *= t;
    }
    sum += std::polar(1.0, -omega * begin) * part;
    begin += t;
  }
  return sum;
}

}  // namespace toolpace
