#pragma once
/// How much of a Newton step is taken, place by place (bodies of NewtonRound).

#include "toolpace/plan/smooth/newton_round.h"

namespace toolpace::detail::tube {

template <int D>
typename NewtonRound<D>::Vec NewtonRound<D>::change(const Row& r) const {
  Vec dz = Vec::Zero();
  for (int i = 0; i < r.count; ++i) {
    const std::size_t k = r.k + static_cast<std::size_t>(i);
    dz += r.w[i] * bend[k] + pace[k] * r.pace[i];
  }
  return dz;
}

/// Share of the step at which the change of pace alone takes a whole limit.
template <int D>
double NewtonRound<D>::pace_step(const Row& r, const double* limit, double norm, int count) const {
  const Vec dz = change(r);
  double most = 0, square = 0;
  for (int a = 0; a < D; ++a) {
    most = std::max(most, std::abs(dz[a]) / limit[a]);
    square += a < count ? dz[a] * dz[a] : 0.0;
  }
  most = std::max(most, std::sqrt(square) / norm);
  return most > 1 ? 1 / most : 1;
}

template <int D>
double NewtonRound<D>::aim_box(const Vec& z, const Vec& dz, const double* limit, double share, Multiplier* at) {
  double step = 1;
  for (int a = 0; a < D; ++a) {
    const double l = limit[a] * share;
    if (!(l < 1e300)) continue;
    const double use = z[a] / l, d = dz[a] / l;
    step = std::min(step, std::min(at[2 * a].aim(use, d), at[2 * a + 1].aim(-use, -d)));
  }
  return step;
}

template <int D>
double NewtonRound<D>::aim_ball(const Vec& z, const Vec& dz, double limit, double share, int count, Multiplier& at) {
  if (!(limit < 1e300)) return 1;
  const double l = limit * share;
  double square = 0, change = 0;
  for (int a = 0; a < count; ++a) {
    square += z[a] * z[a];
    change += z[a] * dz[a];
  }
  return at.aim((square / (l * l) + 1) / 2, change / (l * l));
}

/// Share of a displacement that the straight-line model bears: sideways two tolerances, forwards so far that the path's
/// bend stays within the tube.
template <int D>
double NewtonRound<D>::move_length(std::size_t k, double tol) const {
  if (pinned(k)) return 1;
  const auto& c = m_->c;
  const Vec v = 0.5 * (c[k + 1] - c[k - 1]), a = c[k - 1] - 2 * c[k] + c[k + 1];
  const double speed = v.norm();
  const double forwards = speed > 0 ? std::abs(bend[k].dot(v)) / speed : 0;
  const double sideways = std::sqrt(std::max(bend[k].squaredNorm() - forwards * forwards, 0.0));
  const double far = 2 * tol + speed * std::min(1.5, std::sqrt(0.6 * tol / (a.norm() + 1e-3 * tol)));
  return std::min(1.0, std::min(2 * tol / std::max(sideways, 1e-300), far / std::max(forwards, 1e-300)));
}

template <int D>
void NewtonRound<D>::shorten() {
  const std::size_t n = m_->size();
  length_.assign(n, 1.0);
  const auto lower = [&](const Row& r, double to) {
    if (to >= 1) return;
    for (int i = 0; i < r.count; ++i) {
      double& l = length_[r.k + static_cast<std::size_t>(i)];
      l = std::min(l, to);
    }
  };
  visit_limits([&](const Row& r, const double* limit, double norm, int count) {
    const Vec dz = change(r);
    const double share = options_.share[r.count - 2];
    Multiplier* at = multipliers.row(r.k, static_cast<std::size_t>(r.count) - 2);
    lower(r, std::min(aim_box(r.value, dz, limit, share, at), aim_ball(r.value, dz, norm, share, count, at[2 * D])));
  });
  visit_pace(
      [&](const Row& r, const double* limit, double norm, int count) { lower(r, pace_step(r, limit, norm, count)); });
  visit_tube([&](const Row& r, double tol, const Mat& project, Multiplier* at) {
    lower(r, aim_ball(r.value, project * change(r), tol, options_.share[3], D, *at));
  });
  for (std::size_t k = 0; k < n; ++k) {
    if (std::abs(pace[k]) > 0.25) length_[k] = std::min(length_[k], 0.25 / std::abs(pace[k]));
    const double tol = tolerance_[k];
    length_[k] = std::min(length_[k], move_length(k, tol));
  }
  // A length that changes along the way breaks what each row kept: by little where it changes slowly.
  smooth_minimum(length_, std::max(kReach / m_->stride, kLeastReach), scratch_);
  for (std::size_t k = 0; k < n; ++k) {
    bend[k] *= length_[k];
    pace[k] *= length_[k];
  }
  multipliers.step(length_, options_.weight);
}

}  // namespace toolpace::detail::tube
