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
  // Control points to either side over which a shortened step is felt.
  static constexpr std::size_t kHurriedReach = 30, kSettlingReach = 240;
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

#include "toolpace/plan/smooth/newton_rows.h"
#include "toolpace/plan/smooth/newton_steps.h"
