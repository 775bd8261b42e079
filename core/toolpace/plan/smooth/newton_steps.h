#pragma once
/// How much of a Newton step is taken, place by place (bodies of NewtonRound).

#include "toolpace/plan/smooth/newton_round.h"

namespace toolpace::tube {

template <int D>
typename NewtonRound<D>::Vec NewtonRound<D>::change(const Row& r) const {
  Vec dz = Vec::Zero();
  for (int i = 0; i < r.count; ++i) {
    const std::size_t k = r.k + static_cast<std::size_t>(i);
    dz += r.w[i] * bend[k] + pace[k] * r.pace[i];
  }
  return dz;
}

/// How far a step may take the use of a share of a limit. While the pace changes, a little beyond the limit is a way
/// through; at the end beyond the share, but nothing may be broken anew.
inline double room(double use, double share, bool hurry) {
  const double most = hurry ? 1.02 : 0.9998 / share;
  return use < most ? most : hurry ? use * 1.02 : use;
}

template <int D>
double NewtonRound<D>::box_step(const Vec& z, const Vec& dz, const double* limit, double share) const {
  double step = 1;
  for (int a = 0; a < D; ++a) {
    const double l = limit[a] * share;
    if (!(l < 1e300)) continue;
    const double use = std::abs(z[a]) / l, after = std::abs(z[a] + dz[a]) / l, most = room(use, share, options_.hurry);
    if (after <= most) continue;
    const double to = (dz[a] > 0 ? most * l - z[a] : -most * l - z[a]) / dz[a];
    step = std::min(step, std::max(to, 0.0));
  }
  return step;
}

template <int D>
double NewtonRound<D>::ball_step(const Vec& z_, const Vec& dz_, double limit, double share, int count) const {
  if (!(limit < 1e300)) return 1;
  Vec z = z_, dz = dz_;
  for (int a = count; a < D; ++a) z[a] = dz[a] = 0;
  const double l = limit * share;
  const double most = room(z.norm() / l, share, options_.hurry) * l;
  if ((z + dz).norm() <= most) return 1;
  const double a = dz.squaredNorm(), b = z.dot(dz), c = z.squaredNorm() - most * most;
  const double root = std::sqrt(std::max(b * b - a * c, 0.0));
  return a > 0 ? std::clamp((root - b) / a, 0.0, 1.0) : 1;
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
    lower(r, std::min(box_step(r.value, dz, limit, share), ball_step(r.value, dz, norm, share, count)));
  });
  visit_pace([&](const Row& r, const double* limit, double norm, int count) {
    const Vec dz = change(r);
    const double share = options_.share[r.count - 2];
    lower(r, std::min(box_step(r.value, dz, limit, share), ball_step(r.value, dz, norm, share, count)));
  });
  visit_tube([&](const Row& r, double tol, const Mat& project) {
    lower(r, ball_step(r.value, project * change(r), tol, options_.share[3], D));
  });
  for (std::size_t k = 0; k < n; ++k) {
    if (std::abs(pace[k]) > 0.25) length_[k] = std::min(length_[k], 0.25 / std::abs(pace[k]));
    const double tol = tolerance_[k];
    length_[k] = std::min(length_[k], move_length(k, tol));
  }
  // A length that changes along the way breaks what each row kept: by little where it changes slowly.
  smooth_minimum(length_, options_.hurry ? kHurriedReach : kSettlingReach, scratch_);
  for (std::size_t k = 0; k < n; ++k) {
    bend[k] *= length_[k];
    pace[k] *= length_[k];
  }
}

}  // namespace toolpace::tube
