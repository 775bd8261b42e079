#include "toolpace/plan/span/tilt.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail {
namespace {

/// Share of a cap by which a curve may pass it, and share by which positions are rounded.
constexpr double kTiltMargin = 1e-10;
constexpr double kPlaceRounding = 1e-15;

/// What a curve must pass to be broken: at low speeds a rounding of the place is more than one of the speed.
double tolerated(const Kernel& k, const SpanLimits& limits) {
  const double place = kPlaceRounding * std::abs(k.position.high);
  return k.cap * (1 + kTiltMargin) + std::max(limits.up.top, limits.down.top) * place / k.cap;
}

bool borders_after(const Kernel& plateau, const Kernel& point) {
  return plateau.is_plateau() && !point.is_plateau() && plateau.end == point.position && plateau.cap == point.cap;
}

bool borders_before(const Kernel& point, const Kernel& plateau) {
  return plateau.is_plateau() && !point.is_plateau() && plateau.position == point.position && plateau.cap == point.cap;
}

/// The ends of a stretch: their tilts are given.
bool is_end(const std::vector<Kernel>& kernels, std::size_t i) { return i == 0 || i + 1 == kernels.size(); }

/// What a plateau keeps between the dips at its borders, and between turns at the ends.
void fit_plateau(std::vector<Kernel>& kernels, std::size_t i) {
  Kernel& k = kernels[i];
  k.left = k.position;
  k.right = k.end;
  if (i > 0 && (borders_before(kernels[i - 1], k) || is_end(kernels, i - 1)))
    k.left = std::max(k.left, kernels[i - 1].right);
  if (i + 1 < kernels.size() && (borders_after(k, kernels[i + 1]) || is_end(kernels, i + 1)))
    k.right = std::min(k.right, kernels[i + 1].left);
}

/// Borders may be crossed slowing down onto a plateau, and speeding up from it, not the other way round.
double allowed_tilt(const std::vector<Kernel>& kernels, std::size_t i, double tilt) {
  if (i + 1 < kernels.size() && borders_before(kernels[i], kernels[i + 1])) return std::min(tilt, 0.0);
  if (i > 0 && borders_after(kernels[i - 1], kernels[i])) return std::max(tilt, 0.0);
  return tilt;
}

/// Takes tilts back until the bottoms stand in order: first by halves, in the end altogether.
class Orderer {
 public:
  Orderer(const SpanLimits& limits, std::vector<Kernel>& kernels) : limits_(limits), kernels_(kernels) {}

  void run() {
    fit_plateaus();
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool in_order = true;
      for (std::size_t i = 1; i < kernels_.size(); ++i) in_order = settle(i, 0.5) && in_order;
      fit_plateaus();
      if (in_order) return;
    }
    for (std::size_t i = 1; i < kernels_.size(); ++i) {
      // A bottom that goes back to its node may meet the one before it.
      for (std::size_t k = i; k > 0 && !settle(k, 0.0); --k) {
      }
    }
    fit_plateaus();
  }

 private:
  static constexpr int kSweeps = 3;

  void fit_plateaus() {
    for (std::size_t i = 0; i < kernels_.size(); ++i) {
      if (kernels_[i].is_plateau()) fit_plateau(kernels_, i);
    }
  }

  /// @return whether a kernel stood in order behind the one before it; if not, both tilts (and those at a plateau's other
  ///         border) are shrunk
  bool settle(std::size_t i, double share) {
    const Kernel& before = kernels_[i - 1];
    const Kernel& k = kernels_[i];
    if (k.is_plateau()) fit_plateau(kernels_, i);
    const bool is_whole = k.left <= k.right;
    if (is_whole && (before.right < k.left || (before.right == k.left && (k.is_plateau() || before.is_plateau())))) {
      return true;
    }
    const bool other_border = i + 1 < kernels_.size() && !is_whole;
    if (is_fixed(i - 1) && is_fixed(i) && !(other_border && kernels_[i + 1].tilt != 0)) return true;
    shrink(i - 1, share);
    shrink(i, share);
    if (other_border) shrink(i + 1, share);
    return false;
  }

  bool is_fixed(std::size_t i) const { return kernels_[i].tilt == 0 || is_end(kernels_, i); }

  void shrink(std::size_t i, double share) {
    if (kernels_[i].tilt != 0 && !is_end(kernels_, i)) set_tilt(kernels_[i], share * kernels_[i].tilt, limits_);
  }

  const SpanLimits& limits_;
  std::vector<Kernel>& kernels_;
};

/// Largest speed of a phase of constant jerk between two times.
double highest(const Phase& p, double t0, double t1) {
  double most = std::max(evaluate(p, t0).speed, evaluate(p, t1).speed);
  if (p.rate < 0) {
    const double top = -p.acceleration / p.rate;
    if (top > t0 && top < t1) most = std::max(most, evaluate(p, top).speed);
  }
  return most;
}

/// Walks along phases; places must not fall.
class Walker {
 public:
  Walker(const std::vector<Phase>& phases, const std::vector<ExactPlace>& position)
      : phase_(phases.data()), end_(phases.data() + phases.size()), position_(position) {}

  /// Largest speed at one place or in a stretch; stops early once it cannot pass `cap`.
  double highest_in(const ExactPlace& from, const ExactPlace& to, double cap) {
    while (phase_ + 1 != end_ && way(phase_[1], from) >= 0) ++phase_;
    double most = 0;
    for (const Phase* p = phase_;; ++p) {
      const bool is_last = p + 1 == end_ || way(p[1], to) <= 0;
      // Most phases stay below the cap as a whole.
      if (highest(*p, 0, p->duration) > cap) {
        const double t0 = way(*p, from) <= 0 ? 0.0 : time_after(*p, way(*p, from));
        const double t1 = is_last ? time_after(*p, way(*p, to)) : p->duration;
        most = std::max(most, highest(*p, t0, t1));
      }
      if (is_last) return most;
    }
  }

 private:
  /// From a phase's start to a place.
  double way(const Phase& p, const ExactPlace& place) const { return (place - position_[p.node]) - p.distance; }

  static double time_after(const Phase& p, double way) {
    double low = 0, high = p.duration;
    double t = p.speed > 0 ? std::min(way / p.speed, high) : high / 2;
    for (int i = 0; i < 60; ++i) {
      const double miss = t * (p.speed + t * (p.acceleration / 2 + t * p.rate / 6)) - way;
      const double speed = p.speed + t * (p.acceleration + t * p.rate / 2);
      (miss < 0 ? low : high) = t;
      double next = t - miss / speed;
      if (!(next >= low && next <= high)) next = (low + high) / 2;
      if (std::abs(next - t) <= 1e-13 * p.duration) return next;
      t = next;
    }
    return t;
  }

  const Phase* phase_;
  const Phase* end_;
  const std::vector<ExactPlace>& position_;
};

}  // namespace

double suitable_tilt(const Kernel& k, double meet, double leave, const SpanLimits& limits) {
  const double steepest = std::max(meet * meet, leave * leave);
  if (!(steepest > 0)) return k.tilt;
  const double jerk = std::min(limits.up.jerk, limits.down.jerk);
  const double weight = std::min(1.0, 2 * jerk * k.cap / steepest);
  const double tilt = k.tilt + weight * ((leave + meet) / 2 - k.tilt);
  const double most = std::sqrt(jerk * k.cap / 2);
  return std::clamp(tilt, -std::min(most, limits.down.top), std::min(most, limits.up.top));
}

void tilt_kernels(const std::vector<HullEntry>& hull, const SpanLimits& limits, std::vector<Kernel>& kernels) {
  for (std::size_t e = 1; e + 1 < hull.size(); ++e) {
    const std::uint32_t index = hull[e].kernel;
    Kernel& k = kernels[index];
    if (k.is_plateau()) continue;
    const double wanted = suitable_tilt(k, hull[e].bridge.meet, hull[e + 1].bridge.leave, limits);
    set_tilt(k, allowed_tilt(kernels, index, wanted), limits);
  }
  Orderer(limits, kernels).run();
}

void tilt_ends(double begin, double end, const SpanLimits& limits, std::vector<Kernel>& kernels) {
  set_tilt(kernels.front(), begin, limits);
  set_tilt(kernels.back(), -end, limits);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    if (kernels[i].is_plateau()) fit_plateau(kernels, i);
  }
}

void drop_all_tilts(const SpanLimits& limits, std::vector<Kernel>& kernels) {
  for (std::size_t i = 1; i + 1 < kernels.size(); ++i) {
    if (kernels[i].tilt != 0) set_tilt(kernels[i], 0.0, limits);
  }
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    if (kernels[i].is_plateau()) fit_plateau(kernels, i);
  }
}

std::vector<std::uint32_t> drop_tilts(const std::vector<HullEntry>& hull, const SpanLimits& limits,
                                      const Broken& broken, std::vector<Kernel>& kernels) {
  std::vector<std::uint32_t> changed;
  std::size_t e = 0, done = 0;
  for (const std::uint32_t k : broken.kernels) {
    while (e + 1 < hull.size() && hull[e].kernel < k) ++e;
    done = std::max(done, e > broken.radius ? e - broken.radius : 0);
    for (; done < std::min(hull.size(), e + broken.radius + 1); ++done) {
      Kernel& near = kernels[hull[done].kernel];
      if (near.tilt == 0 || is_end(kernels, hull[done].kernel)) continue;
      set_tilt(near, 0.0, limits);
      // Its plateau, if it is a border, gets longer.
      const std::uint32_t index = hull[done].kernel;
      const std::uint32_t last = std::min<std::uint32_t>(index + 1, static_cast<std::uint32_t>(kernels.size()) - 1);
      for (std::uint32_t i = index > 0 ? index - 1 : 0; i <= last; ++i) {
        if (kernels[i].is_plateau()) fit_plateau(kernels, i);
        if ((kernels[i].is_plateau() || i == index) && (changed.empty() || changed.back() < i)) changed.push_back(i);
      }
    }
  }
  return changed;
}

std::vector<std::uint32_t> find_broken(const std::vector<Kernel>& kernels, const SpanLimits& limits,
                                       const std::vector<HullEntry>& hull, const PlacedPhases& placed) {
  std::vector<std::uint32_t> broken;
  Walker walker(placed.phases, placed.position);
  std::size_t e = 0;
  for (std::uint32_t i = 1; i + 1 < kernels.size(); ++i) {
    const Kernel& k = kernels[i];
    while (e < hull.size() && hull[e].kernel < i) ++e;
    if (e < hull.size() && hull[e].kernel == i && !k.is_plateau()) continue;
    const double cap = tolerated(k, limits);
    if (walker.highest_in(k.position, k.end, cap) > cap) broken.push_back(i);
  }
  return broken;
}

}  // namespace toolpace::detail
