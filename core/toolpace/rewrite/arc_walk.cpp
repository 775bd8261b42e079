#include "toolpace/rewrite/arc_walk.h"

#include <algorithm>

namespace toolpace::detail::rewrite {
namespace {

constexpr double kMostSine = 0.5;       // of what a chord goes round
constexpr std::size_t kBegin = 16;      // chords that tell the sense of turning
constexpr double kHopeless = 3.0;       // [tolerances] off: no shift of the centre will help
constexpr double kSagittaBound = 1.05;  // of c²/(8ρ), which is short of the sagitta where chords are long
constexpr double kBendOfAngle = 0.02;   // by how much the angle along a chord of 1 rad is off even, at most

/// asin for magnitudes up to kMostSine, to 3e-6.
double small_asin(double s) {
  const double q = s * s;
  return s * (1 + q * (1.0 / 6 + q * (3.0 / 40 + q * (15.0 / 336 + q * (105.0 / 3456 + q * (945.0 / 42240))))));
}

double length(const Flat& p) { return std::sqrt(dot(p, p)); }

class Walker {
 public:
  Walker(const FlatPoints& chain, const ArcShape& arc, double tolerance, std::vector<double>& angles)
      : chain_(chain),
        arc_(arc),
        tolerance_(tolerance),
        angles_(angles),
        radius_(length(arc.start - arc.centre)),
        slack_(tolerance - std::fabs(length(arc.end - arc.centre) - radius_)) {}

  ArcWalk run() {
    double sum = 0.0;
    for (std::size_t k = 1; k < std::min(chain_.size(), kBegin + 1); ++k)
      sum += cross(chain_[k - 1] - arc_.centre, chain_[k] - arc_.centre);
    turn_ = sum < 0.0 ? -1.0 : 1.0;
    walk_.clockwise = turn_ < 0.0;
    if (!go_round()) return walk_;
    walk_.goes_round = true;
    const double off = std::max(walk_.out, -walk_.in);
    walk_.fits = off * off + lag_ * lag_ <= slack_ * slack_ && slack_ > 0.0;
    if (walk_.fits && has_heights_) walk_.fits = heights_fit();
    return walk_;
  }

 private:
  double bound_inside(const Flat& from, const Flat& to, double least) const {
    const Flat way = to - from;
    return least - dot(way, way) / (8 * least) * kSagittaBound;
  }

  bool step(const Flat& from, const Flat& to, double from_radius, double to_radius, double& angle) const {
    const double sine = turn_ * cross(from, to) / (from_radius * to_radius);
    if (!(dot(from, to) > 0.0) || std::fabs(sine) > kMostSine) return false;
    angle += small_asin(sine);
    return true;
  }

  bool go_round() {
    angles_.resize(chain_.size());
    Flat at = arc_.start - arc_.centre;
    double rho = radius_, angle = 0.0, farthest = 0.0;
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      const Flat next = chain_[k] - arc_.centre;
      const double next_rho = length(next);
      if (!step(at, next, rho, next_rho, angle)) return false;
      angles_[k] = angle;
      farthest = std::max(farthest, angle);
      lag_ = std::max(lag_, (farthest - angle) * next_rho);
      const double inner = (k == 0 ? next_rho : bound_inside(at, next, std::min(rho, next_rho))) - radius_;
      const double outer = next_rho - radius_;
      if (outer > walk_.out) walk_.out = outer, walk_.out_at = chain_[k];
      if (inner < walk_.in) walk_.in = inner, walk_.in_at = chain_[k];
      if (std::max(outer, -inner) > kHopeless * tolerance_) return false;
      has_heights_ = has_heights_ || chain_[k].w != arc_.start.w;
      at = next, rho = next_rho;
    }
    const Flat end = arc_.end - arc_.centre;
    if (!step(at, end, rho, length(end), angle)) return false;
    has_heights_ = has_heights_ || arc_.end.w != arc_.start.w;
    walk_.sweep = angle;
    lag_ = std::max({lag_, (farthest - angle) * radius_, (angle - angles_.back()) * radius_});
    return angle > 0.0 && lag_ <= tolerance_;
  }

  /// The same with the distance along the normal.
  bool heights_fit() const {
    const double rise = (arc_.end.w - arc_.start.w) / walk_.sweep;
    double farthest = 0.0, last_off = 0.0, last_rho = radius_;
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      const Flat at = chain_[k] - arc_.centre;
      farthest = std::clamp(angles_[k], farthest, std::max(farthest, walk_.sweep));
      const double rho = length(at), step = k == 0 ? 0.0 : std::fabs(angles_[k] - angles_[k - 1]);
      const double off = std::fabs(chain_[k].w - arc_.start.w - rise * farthest), least = std::min(rho, last_rho);
      const double inner = k == 0 ? rho : bound_inside(chain_[k - 1], chain_[k], least);
      const double across = std::max({std::fabs(rho - radius_), std::fabs(last_rho - radius_), radius_ - inner});
      const double uneven =
          std::fabs(rise) * step * (kBendOfAngle * step * step + std::fabs(rho - last_rho) / (2 * least));
      const double along = std::max(off, last_off) + uneven, lag = (farthest - angles_[k]) * rho;
      if (across * across + along * along + lag * lag > slack_ * slack_) return false;
      last_rho = rho, last_off = off;
    }
    return true;
  }

  const FlatPoints& chain_;
  const ArcShape& arc_;
  double tolerance_;
  std::vector<double>& angles_;
  double radius_, slack_;
  double turn_ = 1.0, lag_ = 0.0;
  bool has_heights_ = false;
  ArcWalk walk_;
};

}  // namespace

ArcWalk walk_arc(const FlatPoints& chain, const ArcShape& arc, double tolerance, std::vector<double>& angles) {
  return Walker(chain, arc, tolerance, angles).run();
}

bool walk_line(const FlatPoints& chain, const Flat& start, const Flat& end, double tolerance) {
  const Flat way = end - start;
  const double square = dot(way, way) + way.w * way.w, per_length = square > 0.0 ? 1.0 / square : 0.0;
  double share = 0.0;
  for (const Flat& p : chain) {
    const Flat from = p - start;
    share = std::min(1.0, std::max(share, (dot(from, way) + from.w * way.w) * per_length));
    const double u = from.u - share * way.u, v = from.v - share * way.v, w = from.w - share * way.w;
    if (u * u + v * v + w * w > tolerance * tolerance) return false;
  }
  const Flat rest = chain.back() - end;
  return dot(rest, rest) + rest.w * rest.w <= tolerance * tolerance;
}

}  // namespace toolpace::detail::rewrite
