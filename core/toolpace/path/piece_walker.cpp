#include "toolpace/path/piece_walker.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr std::size_t kSpeedNodes = 16, kHalfNodes = kSpeedNodes / 2;
/// cos(π·k/32), k = 0 … 16.
constexpr double kCosines[] = {1,
                               0.99518472667219693,
                               0.98078528040323043,
                               0.95694033573220882,
                               0.92387953251128674,
                               0.88192126434835505,
                               0.83146961230254524,
                               0.77301045336273699,
                               0.70710678118654757,
                               0.63439328416364549,
                               0.55557023301960229,
                               0.47139673682599781,
                               0.38268343236508984,
                               0.29028467725446233,
                               0.19509032201612833,
                               0.09801714032956077,
                               0};
constexpr double kFallingTail = 1e-11;   // of the mean speed: terms of the speed that are still falling fast
constexpr double kLengthsAgree = 1e-12;  // of a piece, whose length is known otherwise
constexpr double kLeftOut = 1e-17;       // of the length, that left out terms may have
constexpr double kLeastEndSpeed =
    1e-3;  // of the mean: at an end with less the parameter is no smooth function of the length
constexpr int kHalleySteps = 8;
constexpr double kLastHalley = 1e-5;  // of x: a step of third order leaves its cube

constexpr double cosine(std::size_t k) {
  const std::size_t r = k % 64, folded = r <= 32 ? r : 64 - r;
  return folded <= 16 ? kCosines[folded] : -kCosines[32 - folded];
}

/// Of Chebyshev's polynomial k at node i.
constexpr auto kChebyshev = [] {
  std::array<std::array<double, kHalfNodes>, kSpeedNodes> table{};
  for (std::size_t k = 0; k < kSpeedNodes; ++k) {
    for (std::size_t i = 0; i < kHalfNodes; ++i) table[k][i] = cosine(k * (2 * i + 1));
  }
  return table;
}();

/// Coefficients of the interpolant through values at cos(π(i + ½)/16), from the two halves of which even and odd ones are.
std::array<double, kSpeedNodes> chebyshev_terms(const std::array<double, kSpeedNodes>& values) {
  std::array<double, kHalfNodes> sum, difference;
  for (std::size_t i = 0; i < kHalfNodes; ++i) {
    sum[i] = values[i] + values[kSpeedNodes - 1 - i];
    difference[i] = values[i] - values[kSpeedNodes - 1 - i];
  }
  std::array<double, kSpeedNodes> c;
  for (std::size_t k = 0; k < kSpeedNodes; ++k) {
    const auto& folded = k % 2 == 0 ? sum : difference;
    double total = 0;
    for (std::size_t i = 0; i < kHalfNodes; ++i) total += kChebyshev[k][i] * folded[i];
    c[k] = total / kHalfNodes;
  }
  c[0] /= 2;
  return c;
}

/// The same sum by powers, by Clenshaw's rule on polynomials. Its terms fall faster than those of the powers grow.
template <std::size_t count>
std::array<double, count> by_powers(const std::array<double, count>& c, std::size_t degree) {
  std::array<double, count> next{}, second{};
  // Each round overwrites the second to last sum: 2x·next − second + c[k].
  for (std::size_t k = degree; k > 0; --k) {
    for (std::size_t i = degree - k + 1; i-- > 1;) second[i] = 2 * next[i - 1] - second[i];
    second[0] = c[k] - second[0];
    std::swap(next, second);
  }
  for (std::size_t i = degree + 1; i-- > 1;) second[i] = next[i - 1] - second[i];
  second[0] = c[0] - second[0];
  return second;
}

}  // namespace

PieceWalker::PieceWalker(const SplineCurve& curve, const SplinePiece& piece, double length)
    : curve_(&curve), middle_((piece.begin + piece.end) / 2), half_((piece.end - piece.begin) / 2), whole_(length) {
  find_terms();
  is_exact_ = find_length(length);
  if (is_exact_) find_guess(length);
}

/// Taylor's terms at the middle: de Boor's algorithm on the differences of the control points.
void PieceWalker::find_terms() {
  const SplineCurve& c = *curve_;
  const auto p = static_cast<std::size_t>(c.degree);
  const auto first = c.knots.begin() + static_cast<std::ptrdiff_t>(p + 1);
  const auto last = c.knots.begin() + static_cast<std::ptrdiff_t>(c.points.size());
  const std::size_t span = static_cast<std::size_t>(std::upper_bound(first, last, middle_) - c.knots.begin()) - 1;
  std::array<Eigen::Vector4d, 10> control;
  for (std::size_t i = 0; i <= p; ++i) control[i] = c.points[span - p + i];
  double scale = 1;
  for (std::size_t k = 0; k <= p; ++k) {
    auto work = control;
    const std::size_t q = p - k;
    for (std::size_t r = 1; r <= q; ++r) {
      for (std::size_t i = q; i >= r; --i) {
        const double a = c.knots[span - q + i], b = c.knots[span + 1 + i - r];
        const double t = b > a ? (middle_ - a) / (b - a) : 0.0;
        work[i] = (1 - t) * work[i - 1] + t * work[i];
      }
    }
    terms_[k] = scale * work[q];
    for (std::size_t i = 0; i < q; ++i) {
      const double width = c.knots[span + 1 + i] - c.knots[span + 1 + i - q];
      const double rate = width > 0 ? static_cast<double>(q) / width : 0.0;
      control[i] = rate * (control[i + 1] - control[i]);
    }
    scale *= half_ / static_cast<double>(k + 1);
  }
}

/// Length by x.
double PieceWalker::speed_at(double x) const {
  const auto p = static_cast<std::size_t>(curve_->degree);
  Eigen::Vector4d value = terms_[p], slope = Eigen::Vector4d::Zero();
  for (std::size_t k = p; k-- > 0;) {
    slope = slope * x + value;
    value = value * x + terms_[k];
  }
  if (curve_->is_polynomial) return slope.head<3>().norm();
  const double w = value[3];
  return (slope.head<3>() - (slope[3] / w) * value.head<3>()).norm() / w;
}

/// Integrates the speed, as the polynomial through it at sixteen places.
bool PieceWalker::find_length(double length) {
  std::array<double, kSpeedNodes> speed;
  for (std::size_t i = 0; i < kSpeedNodes; ++i)
    speed[i] = speed_at(i < kHalfNodes ? kChebyshev[1][i] : -kChebyshev[1][kSpeedNodes - 1 - i]);
  const std::array<double, kSpeedNodes> c = chebyshev_terms(speed);
  if (!(std::abs(c[kSpeedNodes - 1]) + std::abs(c[kSpeedNodes - 2]) <= kFallingTail * c[0])) return false;
  std::array<double, kMostTerms> sum{};
  for (std::size_t k = 1; k < kMostTerms; ++k) {
    const double before = k == 1 ? 2 * c[0] : c[k - 1], after = k + 1 < kSpeedNodes ? c[k + 1] : 0.0;
    sum[k] = (before - after) / (2 * static_cast<double>(k));
  }
  degree_ = kMostTerms - 1;
  for (double left = 0; degree_ > 2; --degree_) {
    left += std::abs(sum[degree_]);
    if (left > kLeftOut * length) break;
  }
  double begin = 0, end = 0;
  for (std::size_t k = degree_; k > 0; --k) {
    end += sum[k];
    begin += k % 2 == 0 ? sum[k] : -sum[k];
  }
  if (!(std::abs(end - begin - length) <= kLengthsAgree * length)) return false;
  sum[0] = -begin;
  length_ = by_powers(sum, degree_);
  return true;
}

/// x by the length, where both and their slopes are known.
void PieceWalker::find_guess(double length) {
  middle_length_ = length_[0];
  const double mean = length / 2;
  const std::array<double, 3> speed = {speed_at(-1), length_[1], speed_at(1)};
  if (std::min({speed[0], speed[1], speed[2]}) < kLeastEndSpeed * mean) {
    is_exact_ = false;
    return;
  }
  const std::array<double, 6> s = {0, 0, middle_length_, middle_length_, length, length};
  guess_ = {-1, -1, 0, 0, 1, 1};
  for (std::size_t order = 1; order < 6; ++order) {
    for (std::size_t i = 5; i >= order; --i) {
      const bool is_slope = order == 1 && i % 2 == 1;
      guess_[i] = is_slope ? 1 / speed[i / 2] : (guess_[i] - guess_[i - 1]) / (s[i] - s[i - order]);
    }
  }
}

/// x at a length: Halley's steps.
double PieceWalker::place_at(double s) const {
  const double a = s, b = s - middle_length_, c = s - whole_;
  double x = guess_[0] + a * (guess_[1] + a * (guess_[2] + b * (guess_[3] + b * (guess_[4] + c * guess_[5]))));
  for (int i = 0; i < kHalleySteps; ++i) {
    double length = length_[degree_], speed = 0, half_change = 0;
    for (std::size_t k = degree_; k-- > 0;) {
      half_change = half_change * x + speed;
      speed = speed * x + length;
      length = length * x + length_[k];
    }
    const double newton = (s - length) / speed;
    const double step = newton / (1 + newton * half_change / speed);
    x = std::clamp(x + step, -1.0, 1.0);
    if (std::abs(step) <= kLastHalley) break;
  }
  return x;
}

AxisVector PieceWalker::point_at(double s) const {
  const double x = place_at(s);
  const SplineCurve& c = *curve_;
  const auto p = static_cast<std::size_t>(c.degree);
  Eigen::Vector4d value = terms_[p];
  for (std::size_t k = p; k-- > 0;) value = value * x + terms_[k];
  const double begin = c.knots[p], whole = c.knots[c.points.size()] - begin;
  AxisVector point = c.rotary_begin + ((middle_ - begin) + half_ * x) / whole * (c.rotary_end - c.rotary_begin);
  point.head<3>() = c.is_polynomial ? value.head<3>() : Eigen::Vector3d(value.head<3>() / value[3]);
  return point;
}

}  // namespace toolpace
