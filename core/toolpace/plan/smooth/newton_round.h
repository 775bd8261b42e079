#pragma once
/// One Newton step of the barrier problem: how to bend and how to hurry a motion.
///
/// Unknown at each control point: a displacement (D numbers) and the logarithm g of the local pace u̇ = e^g. To first order
///   speed' = speed·(1+g) + δ′,  acceleration' = a(1+2g) + v·g′ + δ″,  jerk' = j(1+3g) + 3a·g′ + v·g″ + δ‴,
/// all differences of control points, so limits on them hold for all t. The sum of e^−g (the duration) plus barriers of
/// every limit is minimised: one step of a joint retiming and recentring (METHODS: they alternate there).

#include <array>
#include <cstddef>
#include <vector>

#include "toolpace/plan/smooth/barrier.h"
#include "toolpace/plan/smooth/block_band.h"
#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/smooth_minimum.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::tube {

struct RoundOptions {
  double weight = 0.01;            ///< of the barrier against time
  double edge = 0.98;              ///< where the barrier becomes a parabola
  bool hurry = true;               ///< may change the pace; otherwise only the shape, at fixed duration
  double share[4] = {1, 1, 1, 1};  ///< of the limits of speed, acceleration, jerk and of the tolerance that may be used
};

template <int D>
class NewtonRound {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  using Mat = Eigen::Matrix<double, D, D>;

  NewtonRound(const TubePath& path, const StepLimits& limits) : path_(path), limits_(limits) {}

  /// Fills bend and pace, shortened locally so that no limit is newly broken.
  bool solve(const MotionWindow<D>& m, const RoundOptions& options);

  /// Mean of |g|: how much the last step still changed the pace.
  double mean_pace() const {
    double sum = 0;
    for (const double g : pace) sum += std::abs(g);
    return sum / static_cast<double>(pace.size());
  }

  std::vector<Vec> bend;     ///< displacement of each control point
  std::vector<double> pace;  ///< g at each control point
  double worst = 0;          ///< largest use of a limit before the step

 private:
  static constexpr int kBlock = D + 1;
  /// A linear vector quantity: value + Σ w_i·δ_i + Σ pace_i·g_i over `count` control points from `k`.
  struct Row {
    std::size_t k;
    int count;
    double w[4];
    Vec value;
    Vec pace[4];
  };
  struct Quadratic {
    Vec gradient = Vec::Zero();
    Mat hessian = Mat::Zero();
  };

  void speed_row(std::size_t k, Row& r) const;
  void acceleration_row(std::size_t k, Row& r) const;
  void jerk_row(std::size_t k, Row& r) const;
  template <class Visit>
  void visit_limits(Visit&& visit) const;
  template <class Visit>
  void visit_tube(Visit&& visit) const;
  template <class Visit>
  void visit_pace(Visit&& visit) const;
  void box(const Vec& z, const double* limit, double share, Quadratic& q);
  void ball(const Vec& z, double limit, double share, int count, Quadratic& q);
  void add(const Row& r, const Quadratic& q);
  void add_regular();
  double box_step(const Vec& z, const Vec& dz, const double* limit, double share) const;
  double ball_step(const Vec& z, const Vec& dz, double limit, double share, int count) const;
  Vec change(const Row& r) const;
  void shorten();
  double move_length(std::size_t k, double tol) const;
  bool pinned(std::size_t k) const { return k < 3 || k + 3 >= m_->size(); }
  bool paced(std::size_t k) const {
    return options_.hurry && k >= (m_->rest_begin ? 3 : 4) && k + (m_->rest_end ? 3 : 4) < m_->size();
  }
  void read_path();

  const TubePath& path_;
  const StepLimits& limits_;
  const MotionWindow<D>* m_ = nullptr;
  RoundOptions options_;
  Barrier barrier_{0.98};
  BlockBand<kBlock> system_;
  std::vector<double> feed_, tolerance_, length_, scratch_;
};

// ---------------------------------------------------------------- rows

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
    visit(r, limits_.order[0], feed_[k], limits_.linear);
    if (k + 2 < n) {
      acceleration_row(k, r);
      visit(r, limits_.order[1], limits_.norm[1], limits_.linear);
    }
    if (k + 3 < n) {
      jerk_row(k, r);
      visit(r, limits_.order[2], limits_.norm[2], limits_.linear);
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
    visit(r, limits_.order[2], limits_.norm[2], limits_.linear);
    r.count = 2;
    r.pace[1] = c[k + 1] - c[k];
    r.pace[0] = -r.pace[1];
    visit(r, limits_.order[1], limits_.norm[1], limits_.linear);
  }
}

/// visit(row of the distance, tolerance, projector onto what counts)
template <int D>
template <class Visit>
void NewtonRound<D>::visit_tube(Visit&& visit) const {
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
    for (int i = 0; i < limits_.samples; ++i) {
      const double t = static_cast<double>(i) / limits_.samples;
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
        visit(r, std::min(path_.tolerance[s], path_.tolerance[s + 1]), project);
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
      visit(r, path_.tolerance[s], project);
    }
  }
}

template <int D>
void NewtonRound<D>::read_path() {
  const auto& m = *m_;
  std::vector<double> cell(m.size(), limits_.norm[0]);
  tolerance_.assign(m.size(), path_.tolerance[m.first]);
  std::size_t s = m.first, next = 0;
  for (std::size_t k = 0; k < m.size(); ++k) {
    cell[k] = std::min(cell[k], path_.feed[s] * limits_.step);
    tolerance_[k] = path_.tolerance[s];
    while (next < m.pass.size() && m.pass[next] < static_cast<double>(k + 1)) {
      ++s;
      ++next;
      cell[k] = std::min(cell[k], path_.feed[s] * limits_.step);
    }
  }
  feed_.assign(m.size(), 0);
  for (std::size_t k = 0; k < m.size(); ++k) {
    feed_[k] = cell[k];
    if (k > 0) feed_[k] = std::min(feed_[k], cell[k - 1]);
    if (k + 1 < m.size()) feed_[k] = std::min(feed_[k], cell[k + 1]);
  }
}

// ---------------------------------------------------------------- assembly

template <int D>
void NewtonRound<D>::box(const Vec& z, const double* limit, double share, Quadratic& q) {
  for (int a = 0; a < D; ++a) {
    const double l = limit[a] * share;
    if (!(l < 1e300)) continue;
    const double use = std::abs(z[a]) / l;
    if (use > worst) worst = use;
    const double w = options_.weight / (l * l);
    q.gradient[a] += w * barrier_.slope_by_use(use) * z[a];
    q.hessian(a, a) += w * barrier_.curvature(use);
  }
}

template <int D>
void NewtonRound<D>::ball(const Vec& z, double limit, double share, int count, Quadratic& q) {
  if (!(limit < 1e300)) return;
  const double l = limit * share;
  Vec y = z;
  for (int a = count; a < D; ++a) y[a] = 0;
  const double size = y.norm(), use = size / l;
  if (use > worst) worst = use;
  const double w = options_.weight / (l * l);
  const double side = w * barrier_.slope_by_use(use);
  q.gradient += side * y;
  for (int a = 0; a < count; ++a) q.hessian(a, a) += side;
  if (size > 0) q.hessian += (w * barrier_.curvature(use) - side) / (size * size) * y * y.transpose();
}

template <int D>
void NewtonRound<D>::add(const Row& r, const Quadratic& q) {
  Vec hp[4];
  double gp[4];
  bool free[4], run[4];
  for (int i = 0; i < r.count; ++i) {
    const std::size_t k = r.k + static_cast<std::size_t>(i);
    free[i] = !pinned(k);
    run[i] = paced(k);
    hp[i].noalias() = q.hessian * r.pace[i];
    gp[i] = q.gradient.dot(r.pace[i]);
  }
  for (int i = 0; i < r.count; ++i) {
    const std::size_t k = r.k + static_cast<std::size_t>(i);
    auto& rhs = system_.right(k);
    if (free[i]) rhs.template head<D>() -= r.w[i] * q.gradient;
    if (run[i]) rhs[D] -= gp[i];
    for (int j = 0; j <= i; ++j) {
      auto& block = system_.at(k, static_cast<std::size_t>(i - j));
      if (free[i] && free[j]) block.template topLeftCorner<D, D>() += (r.w[i] * r.w[j]) * q.hessian;
      if (free[i] && run[j]) block.template topRightCorner<D, 1>() += r.w[i] * hp[j];
      if (run[i] && free[j]) block.template bottomLeftCorner<1, D>() += r.w[j] * hp[i].transpose();
      if (run[i] && run[j]) block(D, D) += r.pace[i].dot(hp[j]);
    }
  }
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

// ---------------------------------------------------------------- step length

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
  smooth_minimum(length_, 30, scratch_);
  for (std::size_t k = 0; k < n; ++k) {
    bend[k] *= length_[k];
    pace[k] *= length_[k];
  }
}

template <int D>
bool NewtonRound<D>::solve(const MotionWindow<D>& m, const RoundOptions& options) {
  m_ = &m;
  options_ = options;
  barrier_ = Barrier(options.edge);
  worst = 0;
  read_path();
  const std::size_t n = m.size();
  system_.reset(n);
  add_regular();
  visit_limits([&](const Row& r, const double* limit, double norm, int count) {
    Quadratic q;
    const double share = options_.share[r.count - 2];
    box(r.value, limit, share, q);
    ball(r.value, norm, share, count, q);
    add(r, q);
  });
  visit_pace([&](const Row& r, const double* limit, double norm, int count) {
    Quadratic q;
    const double share = options_.share[r.count - 2];
    box(r.value, limit, share, q);
    ball(r.value, norm, share, count, q);
    add(r, q);
  });
  visit_tube([&](const Row& r, double tol, const Mat& project) {
    Quadratic q;
    ball(r.value, tol, options_.share[3], D, q);
    q.gradient = project * q.gradient;
    q.hessian = project * q.hessian * project.transpose();
    add(r, q);
  });
  if (!system_.solve()) return false;
  bend.resize(n);
  pace.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    bend[k] = system_.solution()[k].template head<D>();
    pace[k] = system_.solution()[k][D];
    if (pinned(k)) bend[k].setZero();
    if (!paced(k)) pace[k] = 0;
  }
  shorten();
  return true;
}

}  // namespace toolpace::tube
