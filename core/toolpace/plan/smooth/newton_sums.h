#pragma once
/// What each row adds to the system of a Newton step (bodies of NewtonRound).

#include "toolpace/plan/smooth/newton_round.h"

namespace toolpace::detail::tube {

template <int D>
void NewtonRound<D>::pull_box(const Vec& z, const double* limit, double share, Multiplier* at, Quadratic& q) {
  for (int a = 0; a < D; ++a) {
    const double l = limit[a] * share;
    if (!(l < 1e300)) continue;
    const double by = 1 / l, use = z[a] * by;
    const auto up = at[2 * a].pull(use, options_.weight), down = at[2 * a + 1].pull(-use, options_.weight);
    q.gradient[a] += (up.slope - down.slope) * by;
    q.diagonal[a] += (up.curvature + down.curvature) * by * by;
  }
}

template <int D>
void NewtonRound<D>::pull_ball(const Vec& z, double limit, double share, int count, Multiplier& at, Quadratic& q) {
  if (!(limit < 1e300)) return;
  const double by = 1 / (limit * share);
  Vec y = by * z;
  for (int a = count; a < D; ++a) y[a] = 0;
  // As (use² + 1)/2, smooth everywhere and 1 where the use is 1.
  const auto pull = at.pull((y.squaredNorm() + 1) / 2, options_.weight);
  q.gradient += pull.slope * by * y;
  for (int a = 0; a < count; ++a) q.diagonal[a] += at.price * by * by;
  q.rest = pull.curvature * by * by * y * y.transpose();
  q.has_rest = true;
}

template <int D>
void NewtonRound<D>::add(const Row& r, const Quadratic& q) {
  add_bend(r, q);
  if (!options_.hurry) return;
  if (paced(r.k) && paced(r.k + static_cast<std::size_t>(r.count) - 1)) {
    if (r.count == 2) return add_to_pace_inside<2>(r, q);
    if (r.count == 3) return add_to_pace_inside<3>(r, q);
    return add_to_pace_inside<4>(r, q);
  }
  add_to_pace(r, q);
}

/// What bending has to do with a row.
template <int D>
void NewtonRound<D>::add_bend(const Row& r, const Quadratic& q) {
  if (!pinned(r.k) && !pinned(r.k + static_cast<std::size_t>(r.count) - 1)) {
    if (q.has_rest) return add_inside<true>(r, q.full());
    return add_inside<false>(r, q);
  }
  for (int i = 0; i < r.count; ++i) {
    const std::size_t k = r.k + static_cast<std::size_t>(i);
    if (pinned(k)) continue;
    system_.right(k).template head<D>() -= r.w[i] * q.gradient;
    for (int j = 0; j <= i; ++j) {
      if (pinned(r.k + static_cast<std::size_t>(j))) continue;
      q.add_to(system_.at(k, static_cast<std::size_t>(i - j)).template topLeftCorner<D, D>(), r.w[i] * r.w[j]);
    }
  }
}

/// A row all of whose control points may be moved.
/// @param q  all in its full matrix, or none of it
template <int D>
template <bool IsFull>
void NewtonRound<D>::add_inside(const Row& r, const Quadratic& q) {
  if (r.count == 2) return add_inside<IsFull, 2>(r, q);
  if (r.count == 3) return add_inside<IsFull, 3>(r, q);
  return add_inside<IsFull, 4>(r, q);
}

template <int D>
template <bool IsFull, int Count>
void NewtonRound<D>::add_inside(const Row& r, const Quadratic& q) {
  auto* const block = &system_.at(r.k, 0);
  auto* const right = &system_.right(r.k);
  for (int i = 0; i < Count; ++i) {
    right[i].template head<D>() -= r.w[i] * q.gradient;
    for (int j = 0; j <= i; ++j) {
      q.template add_to<IsFull>(block[i * kBlocks + i - j].template topLeftCorner<D, D>(), r.w[i] * r.w[j]);
    }
  }
}

/// What the pace has to do with a row.
template <int D>
void NewtonRound<D>::add_to_pace(const Row& r, const Quadratic& q) {
  for (int j = 0; j < r.count; ++j) {
    const std::size_t l = r.k + static_cast<std::size_t>(j);
    if (!paced(l)) continue;
    const Vec pull = q.times(r.pace[j]);
    system_.right(l)[D] -= q.gradient.dot(r.pace[j]);
    for (int i = 0; i < r.count; ++i) {
      const std::size_t k = r.k + static_cast<std::size_t>(i);
      auto& block = system_.at(std::max(k, l), k > l ? k - l : l - k);
      if (i >= j && paced(k)) block(D, D) += r.pace[i].dot(pull);
      if (i >= j && !pinned(k)) block.template topRightCorner<D, 1>() += r.w[i] * pull;
      if (i <= j && !pinned(k)) block.template bottomLeftCorner<1, D>() += r.w[i] * pull.transpose();
    }
  }
}

/// The same where all of the row's control points may be moved and paced.
template <int D>
template <int Count>
void NewtonRound<D>::add_to_pace_inside(const Row& r, const Quadratic& q) {
  auto* const block = &system_.at(r.k, 0);
  auto* const right = &system_.right(r.k);
  Vec pull[Count];
  for (int i = 0; i < Count; ++i) {
    pull[i] = q.times(r.pace[i]);
    right[i][D] -= q.gradient.dot(r.pace[i]);
  }
  for (int i = 0; i < Count; ++i) {
    for (int j = 0; j <= i; ++j) {
      auto& at = block[i * kBlocks + i - j];
      at.template topRightCorner<D, 1>() += r.w[i] * pull[j];
      at.template bottomLeftCorner<1, D>() += r.w[j] * pull[i].transpose();
      at(D, D) += r.pace[i].dot(pull[j]);
    }
  }
}

/// Keeps what visit_pace() names small.
template <int D>
void NewtonRound<D>::add_pace() {
  const double weight = std::max(kPaceWeight, 2 * options_.weight);
  visit_pace([&](const Row& r, const double* limit, double norm, int count) {
    Vec scale;
    for (int a = 0; a < D; ++a) {
      scale[a] = weight / (limit[a] * limit[a]) + (a < count ? weight / (norm * norm) : 0.0);
    }
    auto* const block = &system_.at(r.k, 0);
    for (int i = 0; i < r.count; ++i) {
      if (!paced(r.k + static_cast<std::size_t>(i))) continue;
      const Vec pull = scale.cwiseProduct(r.pace[i]);
      for (int j = 0; j <= i; ++j) {
        if (paced(r.k + static_cast<std::size_t>(j))) block[i * kBlocks + i - j](D, D) += pull.dot(r.pace[j]);
      }
    }
  });
}

template <int D>
void NewtonRound<D>::add_regular() {
  const auto& m = *m_;
  for (std::size_t k = 0; k < m.size(); ++k) {
    auto& block = system_.at(k, 0);
    if (pinned(k)) {
      block.template topLeftCorner<D, D>().diagonal().array() += 1;
    } else {
      const double tol = tolerance_[k];
      block.template topLeftCorner<D, D>().diagonal().array() += 1e-4 * options_.weight / (tol * tol);
      if (options_.hurry) {
        // Sliding along the path is the pace's work: only where the motion stands still is there no direction to forbid.
        const Vec v = 0.5 * (m.c[k + 1] - m.c[k - 1]);
        const double floor = 0.01 * tol * tol, vv = v.squaredNorm() + floor;
        block.template topLeftCorner<D, D>() += v * v.transpose() / (vv * vv);
      }
    }
    if (paced(k)) {
      block(D, D) += 1;
      system_.right(k)[D] += 1;
    } else {
      block(D, D) += 1;
    }
  }
}

}  // namespace toolpace::detail::tube
