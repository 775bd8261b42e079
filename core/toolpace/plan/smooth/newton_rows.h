#pragma once
/// What a Newton step looks at: the linear rows of limits, pace and tube (bodies of NewtonRound).

#include "toolpace/plan/smooth/newton_round.h"

namespace toolpace::detail::tube {

template <int D>
void NewtonRound<D>::speed_row(std::size_t k, Row& r) const {
  const auto& c = m_->c;
  r.k = k;
  r.count = 2;
  r.w[0] = -1;
  r.w[1] = 1;
  r.value = c[k + 1] - c[k];
  r.pace[0] = r.pace[1] = 0.5 * r.value;
}

template <int D>
void NewtonRound<D>::acceleration_row(std::size_t k, Row& r) const {
  const auto& c = m_->c;
  r.k = k;
  r.count = 3;
  r.w[0] = r.w[2] = 1;
  r.w[1] = -2;
  r.value = c[k] - 2 * c[k + 1] + c[k + 2];
  const Vec v = 0.5 * (c[k + 2] - c[k]);
  r.pace[0] = -0.5 * v;
  r.pace[1] = 2 * r.value;
  r.pace[2] = 0.5 * v;
}

template <int D>
void NewtonRound<D>::jerk_row(std::size_t k, Row& r) const {
  const auto& c = m_->c;
  r.k = k;
  r.count = 4;
  r.w[0] = -1;
  r.w[1] = 3;
  r.w[2] = -3;
  r.w[3] = 1;
  const Vec v = c[k + 2] - c[k + 1];
  const Vec a = 0.5 * (c[k] - c[k + 1] - c[k + 2] + c[k + 3]);
  r.value = c[k + 3] - 3 * v - c[k];
  r.pace[0] = 0.5 * v;
  r.pace[1] = 1.5 * r.value - 3 * a - 0.5 * v;
  r.pace[2] = 1.5 * r.value + 3 * a - 0.5 * v;
  r.pace[3] = 0.5 * v;
}

/// visit(row, axis limits, norm limit, coordinates in the norm)
template <int D>
template <class Visit>
void NewtonRound<D>::visit_limits(Visit&& visit) const {
  const std::size_t n = m_->size();
  Row r;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    speed_row(k, r);
    visit(r, limits_->order[0], feed_[k], limits_->linear);
    if (k + 2 < n) {
      acceleration_row(k, r);
      visit(r, limits_->order[1], limits_->norm[1], limits_->linear);
    }
    if (k + 3 < n) {
      jerk_row(k, r);
      visit(r, limits_->order[2], limits_->norm[2], limits_->linear);
    }
  }
}

/// What a change of pace alone adds between the places where the limits are looked at: jerk v·g″ at the knots, or, without a
/// jerk limit, acceleration v·g′ between them. It is kept to a share of the limit, else an alternating pace would go unseen.
template <int D>
template <class Visit>
void NewtonRound<D>::visit_pace(Visit&& visit) const {
  if (!options_.hurry) return;
  const auto& c = m_->c;
  Row r;
  r.value.setZero();
  for (double& w : r.w) w = 0;
  for (std::size_t k = 0; k + 2 < m_->size(); ++k) {
    const Vec v = 0.5 * (c[k + 2] - c[k]);
    r.k = k;
    r.count = 3;
    r.pace[0] = r.pace[2] = v;
    r.pace[1] = -2 * v;
    visit(r, limits_->order[2], limits_->norm[2], limits_->linear);
    r.count = 2;
    r.pace[1] = c[k + 1] - c[k];
    r.pace[0] = -r.pace[1];
    visit(r, limits_->order[1], limits_->norm[1], limits_->linear);
  }
}

/// visit(row of the distance, tolerance, projector onto what counts)
template <int D>
template <class Visit>
void NewtonRound<D>::visit_tube(Visit&& visit) {
  const auto& m = *m_;
  Row r;
  r.count = 4;
  for (auto& p : r.pace) p.setZero();
  const auto put = [&](std::size_t k, const Basis& b) {
    r.k = k - 1;
    for (int i = 0; i < 4; ++i) r.w[i] = b.w[i];
    r.value = m.combine(k, b);
  };
  std::size_t s = m.first;
  std::size_t next = 0;
  for (std::size_t k = 1; k + 2 < m.size(); ++k) {
    for (int i = 0; i < limits_->aimed; ++i) {
      const double t = static_cast<double>(i) / limits_->aimed;
      const double u = static_cast<double>(k) + t;
      while (next < m.pass.size() && m.pass[next] <= u) {
        // the vertex that is passed here
        double tv;
        const std::size_t kv = m.cell(m.pass[next], tv);
        put(kv, basis(tv));
        const Vec v = m.combine(kv, basis_slope(tv)), a = m.combine(kv, basis_bend(tv));
        r.value -= vertex<D>(path_, s + 1);
        const double vv = v.squaredNorm(), ea = std::max(0.0, r.value.dot(a)), ev = r.value.dot(v);
        // Sliding along the motion only moves the moment of passing, unless the order holds that moment fast.
        const bool held = ev * ev > 0.01 * vv * r.value.squaredNorm();
        Mat project = Mat::Identity();
        if (vv > 0 && !held) project -= v * v.transpose() / (vv + ea);
        visit(r, std::min(path_.tolerance[s], path_.tolerance[s + 1]), project, multipliers.vertex(next, k));
        ++s;
        ++next;
      }
      put(k, basis(t));
      const Vec p = vertex<D>(path_, s);
      const Vec d = vertex<D>(path_, s + 1) - p;
      const double ll = d.squaredNorm();
      const double along = (r.value - p).dot(d) / ll;
      Mat project = Mat::Identity();
      if (along > 0 && along < 1) project -= d * d.transpose() / ll;
      r.value -= p + std::clamp(along, 0.0, 1.0) * d;
      visit(r, path_.tolerance[s], project, multipliers.station(k, static_cast<std::size_t>(i)));
    }
  }
}

template <int D>
void NewtonRound<D>::read_path() {
  const auto& m = *m_;
  std::vector<double> cell(m.size(), limits_->norm[0]);
  tolerance_.assign(m.size(), path_.tolerance[m.first]);
  std::size_t s = m.first, next = 0;
  for (std::size_t k = 0; k < m.size(); ++k) {
    cell[k] = std::min(cell[k], path_.feed[s] * limits_->step);
    tolerance_[k] = path_.tolerance[s];
    while (next < m.pass.size() && m.pass[next] < static_cast<double>(k + 1)) {
      ++s;
      ++next;
      cell[k] = std::min(cell[k], path_.feed[s] * limits_->step);
    }
  }
  feed_.assign(m.size(), 0);
  // A speed reaches into three cells; as steps move the vertices, a feed counts a little earlier and later than that.
  const std::size_t margin = options_.hurry ? kHurriedMargin : kSettlingMargin;
  const std::size_t reach = 1 + (margin + m.stride - 1) / m.stride;
  for (std::size_t k = 0; k < m.size(); ++k) {
    feed_[k] = *std::min_element(cell.begin() + static_cast<std::ptrdiff_t>(k - std::min(k, reach)),
                                 cell.begin() + static_cast<std::ptrdiff_t>(std::min(k + reach + 1, m.size())));
  }
}

}  // namespace toolpace::detail::tube
