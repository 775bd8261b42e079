#include "toolpace/path/spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace toolpace {
namespace {

constexpr int kMaxDegree = 9;
constexpr int kMaxDepth = 8;  // halvings of a knot span
constexpr std::size_t kMaxPieces = 4096;
constexpr double kLengthAccuracy = 1e-13;
constexpr double kCurvatureChange = 1.0 / 3;

struct Homogeneous {
  std::array<Eigen::Vector4d, 4> d;  // point and three derivatives by the parameter
};

struct Cartesian {
  std::array<Eigen::Vector3d, 4> d;
};

std::size_t find_span(const SplineCurve& c, double u) {
  const auto p = static_cast<std::size_t>(c.degree);
  // Knots 1 apart, as those of corner chains, need no search.
  const double from = u - c.knots[p];
  if (from >= 0 && from < static_cast<double>(c.points.size() - p)) {
    const std::size_t guess = p + static_cast<std::size_t>(from);
    if (c.knots[guess] <= u && u < c.knots[guess + 1]) return guess;
  }
  const auto first = c.knots.begin() + static_cast<std::ptrdiff_t>(p + 1);
  const auto last = c.knots.begin() + static_cast<std::ptrdiff_t>(c.points.size());
  return static_cast<std::size_t>(std::upper_bound(first, last, u) - c.knots.begin()) - 1;
}

/// De Boor's algorithm on the span's control points; derivative k uses the k-th differences of the control points.
/// @param orders  derivatives from this one on are not wanted
Homogeneous evaluate_homogeneous(const SplineCurve& c, double u, std::size_t span, std::size_t orders) {
  const auto p = static_cast<std::size_t>(c.degree);
  std::array<Eigen::Vector4d, kMaxDegree + 1> control, work;
  for (std::size_t i = 0; i <= p; ++i) control[i] = c.points[span - p + i];
  Homogeneous result;
  for (std::size_t k = 0; k < orders; ++k) {
    if (k > p) {
      result.d[k].setZero();
      continue;
    }
    const std::size_t q = p - k;  // degree of the k-th derivative
    for (std::size_t i = 0; i <= q; ++i) work[i] = control[i];
    for (std::size_t r = 1; r <= q; ++r) {
      for (std::size_t i = q; i >= r; --i) {
        const double a = c.knots[span - q + i], b = c.knots[span + 1 + i - r];
        const double t = b > a ? (u - a) / (b - a) : 0.0;
        work[i] = (1 - t) * work[i - 1] + t * work[i];
      }
    }
    result.d[k] = work[q];
    for (std::size_t i = 0; i + 1 <= q && k + 1 < orders; ++i) {
      const double width = c.knots[span + 1 + i] - c.knots[span + 1 + i - q];
      control[i] = width > 0 ? Eigen::Vector4d(static_cast<double>(q) / width * (control[i + 1] - control[i]))
                             : Eigen::Vector4d(Eigen::Vector4d::Zero());
    }
  }
  return result;
}

/// Whether the knots that bear on a span of a cubic without weights are evenly spaced, as all but the outer ones of corner
/// chains are.
bool is_uniform_cubic(const SplineCurve& c, std::size_t span) {
  if (c.degree != 3 || !c.is_polynomial) return false;
  const double* knot = c.knots.data() + span;
  const double width = knot[1] - knot[0];
  return knot[-1] - knot[-2] == width && knot[0] - knot[-1] == width && knot[2] - knot[1] == width &&
         knot[3] - knot[2] == width;
}

/// The same as a polynomial from the span's beginning on.
Cartesian evaluate_uniform(const SplineCurve& c, double u, std::size_t span) {
  const auto p = [&](std::size_t i) { return c.points[span - 3 + i].head<3>(); };
  const double scale = 1 / (c.knots[span + 1] - c.knots[span]), x = (u - c.knots[span]) * scale;
  const Eigen::Vector3d start = (p(0) + 4 * p(1) + p(2)) / 6, first = (p(2) - p(0)) / 2;
  const Eigen::Vector3d second = p(0) - 2 * p(1) + p(2), third = p(3) - p(0) + 3 * (p(1) - p(2));
  return {{start + x * (first + x * (second / 2 + x / 6 * third)), scale * (first + x * (second + x / 2 * third)),
           scale * scale * (second + x * third), scale * scale * scale * third}};
}

/// The point alone: the same bits as evaluate() gives, at less than half its cost.
Eigen::Vector3d point_at(const SplineCurve& c, double u, std::size_t span) {
  if (is_uniform_cubic(c, span)) return evaluate_uniform(c, u, span).d[0];
  const Homogeneous h = evaluate_homogeneous(c, u, span, 1);
  return h.d[0].head<3>() / h.d[0][3];
}

/// Quotient rule: C = A/w, C' = (A' − w'C)/w, …
Cartesian evaluate(const SplineCurve& c, double u, std::size_t span) {
  if (is_uniform_cubic(c, span)) return evaluate_uniform(c, u, span);
  const Homogeneous h = evaluate_homogeneous(c, u, span, 4);
  const double w = h.d[0][3], w1 = h.d[1][3], w2 = h.d[2][3], w3 = h.d[3][3];
  Cartesian r;
  r.d[0] = h.d[0].head<3>() / w;
  r.d[1] = (h.d[1].head<3>() - w1 * r.d[0]) / w;
  r.d[2] = (h.d[2].head<3>() - 2 * w1 * r.d[1] - w2 * r.d[0]) / w;
  r.d[3] = (h.d[3].head<3>() - 3 * w1 * r.d[2] - 3 * w2 * r.d[1] - w3 * r.d[0]) / w;
  return r;
}

ParameterDerivatives derivatives(const SplineCurve& c, double u, std::size_t span) {
  const double whole = c.knots[c.points.size()] - c.knots[static_cast<std::size_t>(c.degree)];
  const Cartesian r = evaluate(c, u, span);
  ParameterDerivatives d{(c.rotary_end - c.rotary_begin) / whole, AxisVector::Zero(), AxisVector::Zero()};
  d.first.head<3>() = r.d[1];
  d.second.head<3>() = r.d[2];
  d.third.head<3>() = r.d[3];
  return d;
}

/// The first derivative inside a span: the same bits as evaluate() gives. What does not depend on the place is worked out once, and
/// the shares between knots serve both the curve and its derivative, which is one degree lower on the same knots.
class SpanDerivative {
 public:
  SpanDerivative(const SplineCurve& c, std::size_t span) : p_(static_cast<std::size_t>(c.degree)) {
    for (std::size_t i = 0; i <= p_; ++i) {
      control_[i] = c.points[span - p_ + i];
      knot_[i] = c.knots[span - p_ + i];
    }
    for (std::size_t r = 1; r <= p_; ++r) {
      for (std::size_t i = r; i <= p_; ++i) width_[r][i] = c.knots[span + 1 + i - r] - knot_[i];
    }
    for (std::size_t i = 0; i + 1 <= p_; ++i) {
      const double width = width_[1][i + 1];
      slope_[i] = width > 0 ? Eigen::Vector4d(static_cast<double>(p_) / width * (control_[i + 1] - control_[i]))
                            : Eigen::Vector4d(Eigen::Vector4d::Zero());
    }
  }

  Eigen::Vector3d operator()(double u) const {
    auto point = control_, slope = slope_;
    for (std::size_t r = 1; r <= p_; ++r) {
      for (std::size_t i = p_; i >= r; --i) {
        const double t = width_[r][i] > 0 ? (u - knot_[i]) / width_[r][i] : 0.0;
        point[i] = (1 - t) * point[i - 1] + t * point[i];
        if (r > 1) slope[i - 1] = (1 - t) * slope[i - 2] + t * slope[i - 1];
      }
    }
    const Eigen::Vector4d &h = point[p_], &h1 = slope[p_ - 1];
    const Eigen::Vector3d at = h.head<3>() / h[3];
    return (h1.head<3>() - h1[3] * at) / h[3];
  }

 private:
  std::size_t p_;
  std::array<Eigen::Vector4d, kMaxDegree + 1> control_, slope_;
  std::array<double, kMaxDegree + 1> knot_;
  std::array<std::array<double, kMaxDegree + 1>, kMaxDegree + 1> width_;
};

/// |C'| inside a span and at its ends.
class SpanSpeed {
 public:
  SpanSpeed(const SplineCurve& curve, std::size_t span) : begin_(curve.knots[span]) {
    is_uniform_ = is_uniform_cubic(curve, span);
    if (!is_uniform_) {
      derivative_.emplace(curve, span);
      return;
    }
    const Cartesian start = evaluate_uniform(curve, begin_, span);
    first_ = start.d[1];
    second_ = start.d[2];
    half_third_ = start.d[3] / 2;
  }

  double operator()(double u) const {
    if (!is_uniform_) return (*derivative_)(u).norm();
    const double x = u - begin_;
    return (first_ + x * (second_ + x * half_third_)).norm();
  }

 private:
  std::optional<SpanDerivative> derivative_;  ///< where knots are not even, or points have weights
  double begin_;
  bool is_uniform_;
  Eigen::Vector3d first_, second_, half_third_;
};

/// The span of which a stretch between two neighbouring knots is a part.
std::size_t span_of(const SplineCurve& c, double a, double b) { return find_span(c, (a + b) / 2); }

double curvature(const SplineCurve& c, double u, std::size_t span) {
  const Cartesian r = evaluate(c, u, span);
  const double g = r.d[1].norm();
  return g > 0 ? r.d[1].cross(r.d[2]).norm() / (g * g * g) : 0.0;
}

bool is_fine(const SplineCurve& c, double a, double b) {
  const double middle = (a + b) / 2;
  const std::size_t span = span_of(c, a, b);
  const SpanSpeed speed(c, span);
  const double whole = integrate(speed, a, b);
  const double halves = integrate(speed, a, middle) + integrate(speed, middle, b);
  if (std::abs(whole - halves) > kLengthAccuracy * halves) return false;
  const double ka = curvature(c, a, span), km = curvature(c, middle, span), kb = curvature(c, b, span);
  const double high = std::max({ka, km, kb}), low = std::min({ka, km, kb});
  // A curve that turns by less than a milliradian inside the piece needs no finer cap.
  return high * halves < 1e-3 || high - low <= kCurvatureChange * high;
}

}  // namespace

SplineCurve make_spline(const AxisVector& begin, const AxisVector& end, const SplineDetail& detail) {
  SplineCurve curve{detail.degree, {}, detail.knots, begin, end, detail.weights.empty()};
  curve.points.reserve(detail.points.size());
  for (std::size_t i = 0; i < detail.points.size(); ++i) {
    const double w = detail.weights.empty() ? 1.0 : detail.weights[i];
    curve.points.emplace_back(w * detail.points[i].x(), w * detail.points[i].y(), w * detail.points[i].z(), w);
  }
  return curve;
}

double piece_length(const SplineCurve& c, double a, double b) {
  return integrate(SpanSpeed(c, span_of(c, a, b)), a, b);
}

std::vector<SplinePiece> cut_spline(const SplineCurve& c, std::uint32_t index) {
  struct Stretch {
    double begin, end;
    int depth;
  };
  std::vector<SplinePiece> pieces;
  std::vector<Stretch> stack;
  const auto first = static_cast<std::size_t>(c.degree), last = c.points.size();
  for (std::size_t k = last; k > first; --k) {
    if (c.knots[k] > c.knots[k - 1]) stack.push_back({c.knots[k - 1], c.knots[k], 0});
  }
  while (!stack.empty()) {
    const Stretch s = stack.back();
    stack.pop_back();
    const bool may_split = s.depth < kMaxDepth && pieces.size() + stack.size() < kMaxPieces;
    if (may_split && !is_fine(c, s.begin, s.end)) {
      const double middle = (s.begin + s.end) / 2;
      stack.push_back({middle, s.end, s.depth + 1});
      stack.push_back({s.begin, middle, s.depth + 1});
    } else if (piece_length(c, s.begin, s.end) > 0) {
      pieces.push_back({index, s.begin, s.end});
    }
  }
  return pieces;
}

double parameter_at(const SplineCurve& c, const SplinePiece& piece, double length, double s) {
  const SpanSpeed speed(c, span_of(c, piece.begin, piece.end));
  double low = piece.begin, high = piece.end;
  double u = low + (high - low) * std::clamp(s / length, 0.0, 1.0);
  for (int i = 0; i < 30; ++i) {  // Newton, bracketed
    const double error = integrate(speed, piece.begin, u) - s;
    (error > 0 ? high : low) = u;
    const double slope = speed(u);
    double next = slope > 0 ? u - error / slope : (low + high) / 2;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    // No step that is lost in rounding comes any closer.
    const double finest = std::max(1e-15 * (piece.end - piece.begin), 0x1p-52 * std::abs(u));
    if (std::abs(error) <= 1e-14 * length || std::abs(next - u) <= finest) break;
    u = next;
  }
  return u;
}

AxisVector spline_point(const SplineCurve& c, double u) {
  const double whole = c.knots[c.points.size()] - c.knots[static_cast<std::size_t>(c.degree)];
  const double share = (u - c.knots[static_cast<std::size_t>(c.degree)]) / whole;
  AxisVector point = c.rotary_begin + share * (c.rotary_end - c.rotary_begin);
  point.head<3>() = point_at(c, u, find_span(c, u));
  return point;
}

bool is_smooth_between(const SplineCurve& c, const SplinePiece& before, const SplinePiece& after) {
  if (before.spline != after.spline || before.end != after.begin || c.degree < 2 || !c.is_polynomial) return false;
  const std::size_t span = span_of(c, before.begin, before.end);
  return before.end < c.knots[span + 1] || c.knots[span + 1] < c.knots[span + 2];
}

ParameterDerivatives spline_derivatives(const SplineCurve& c, double u) { return derivatives(c, u, find_span(c, u)); }

ParameterDerivatives spline_derivatives(const SplineCurve& c, const SplinePiece& piece, double u) {
  return derivatives(c, u, find_span(c, (piece.begin + piece.end) / 2));
}

}  // namespace toolpace
