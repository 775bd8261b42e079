#pragma once
/// One Newton step towards the fastest motion: how to bend and how to hurry the present one.
///
/// Unknown at each control point: a displacement (D numbers) and the logarithm g of the local pace u̇ = e^g. To first order
///   speed' = speed·(1+g) + δ′,  acceleration' = a(1+2g) + v·g′ + δ″,  jerk' = j(1+3g) + 3a·g′ + v·g″ + δ‴,
/// all differences of control points, so limits on them hold for all t. The sum of e^−g (the duration) is minimised under
/// every limit by a primal-dual interior-point method (multipliers.h): one step of a joint retiming and recentring.

#include <array>
#include <cstddef>
#include <vector>

#include "toolpace/plan/smooth/block_band.h"
#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/multipliers.h"
#include "toolpace/plan/smooth/smooth_minimum.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::detail::tube {

struct RoundOptions {
  double weight = 0.01;            ///< slack·price of every limit that is aimed at: small = close to the limits
  bool hurry = true;               ///< may change the pace; otherwise only the shape, at fixed duration
  double share[4] = {1, 1, 1, 1};  ///< of the limits of speed, acceleration, jerk and of the tolerance that may be used
};

template <int D>
class NewtonRound {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  using Mat = Eigen::Matrix<double, D, D>;

  explicit NewtonRound(const TubePath& path) : path_(path) {}

  /// Forgets the multipliers.
  /// @param limits  over the motion's steps; must outlive the rounds
  void begin(const MotionWindow<D>& m, const StepLimits& limits) {
    limits_ = &limits;
    multipliers.reset(m.size(), m.pass.size(), limits.aimed);
  }
  /// Goes on with steps half as long.
  void go_on(const MotionWindow<D>& m, const StepLimits& limits) {
    limits_ = &limits;
    multipliers.halve(m.size(), limits.aimed);
  }
  /// Fills bend and pace, shortened locally so that no slack is used up, and steps the multipliers.
  bool solve(const MotionWindow<D>& m, const RoundOptions& options);

  std::vector<Vec> bend;       ///< displacement of each control point
  std::vector<double> pace;    ///< g at each control point
  Multipliers<D> multipliers;  ///< of all limits; moved by who changes the number of points

 private:
  static constexpr int kBlock = D + 1;
  static constexpr int kBlocks = static_cast<int>(BlockBand<kBlock>::kReach) + 1;  // in a row
  static constexpr std::size_t kReach = 30;  // control points to either side over which a shortened step is felt
  static constexpr std::size_t kLeastReach = 6;
  static constexpr double kPaceWeight = 0.02;                            // least, against alternating paces
  static constexpr std::size_t kHurriedMargin = 4, kSettlingMargin = 2;  // cells around a change of feed
  /// A linear vector quantity: value + Σ w_i·δ_i + Σ pace_i·g_i over `count` control points from `k`.
  struct Row {
    std::size_t k;
    int count;
    double w[4];
    Vec value;
    Vec pace[4];
  };
  /// Of a row's vector: most limits are of the axes, and their Hessian is diagonal.
  struct Quadratic {
    Vec gradient = Vec::Zero(), diagonal = Vec::Zero();
    Mat rest;  ///< of the Hessian
    bool has_rest = false;

    using Corner = Eigen::Block<typename BlockBand<kBlock>::Block, D, D>;
    template <bool IsFull>
    void add_to(Corner block, double factor) const {
      if constexpr (IsFull) {
        block += factor * rest;
      } else {
        block.diagonal() += factor * diagonal;
      }
    }
    void add_to(Corner block, double factor) const {
      if (has_rest) add_to<true>(block, factor);
      add_to<false>(block, factor);
    }
    /// All of it in `rest`.
    Quadratic full() const {
      Quadratic q = *this;
      if (!has_rest) q.rest.setZero();
      q.rest.diagonal() += diagonal;
      q.diagonal.setZero();
      q.has_rest = true;
      return q;
    }
    Vec times(const Vec& v) const {
      Vec product = diagonal.cwiseProduct(v);
      if (has_rest) product += rest * v;
      return product;
    }
  };

  void speed_row(std::size_t k, Row& r) const;
  void acceleration_row(std::size_t k, Row& r) const;
  void jerk_row(std::size_t k, Row& r) const;
  template <class Visit>
  void visit_limits(Visit&& visit) const;
  template <class Visit>
  void visit_tube(Visit&& visit);
  template <class Visit>
  void visit_pace(Visit&& visit) const;
  void pull_box(const Vec& z, const double* limit, double share, Multiplier* at, Quadratic& q);
  void pull_ball(const Vec& z, double limit, double share, int count, Multiplier& at, Quadratic& q);
  double aim_box(const Vec& z, const Vec& dz, const double* limit, double share, Multiplier* at);
  double aim_ball(const Vec& z, const Vec& dz, double limit, double share, int count, Multiplier& at);
  void add(const Row& r, const Quadratic& q);
  void add_bend(const Row& r, const Quadratic& q);
  template <bool IsFull>
  void add_inside(const Row& r, const Quadratic& q);
  template <bool IsFull, int Count>
  void add_inside(const Row& r, const Quadratic& q);
  void add_to_pace(const Row& r, const Quadratic& q);
  template <int Count>
  void add_to_pace_inside(const Row& r, const Quadratic& q);
  void add_regular();
  void add_pace();
  double pace_step(const Row& r, const double* limit, double norm, int count) const;
  Vec change(const Row& r) const;
  void shorten();
  double move_length(std::size_t k, double tol) const;
  bool pinned(std::size_t k) const { return k < 3 || k + 3 >= m_->size(); }
  bool paced(std::size_t k) const {
    return options_.hurry && k >= (m_->rest_begin ? 3 : 4) && k + (m_->rest_end ? 3 : 4) < m_->size();
  }
  void read_path();

  const TubePath& path_;
  const StepLimits* limits_ = nullptr;
  const MotionWindow<D>* m_ = nullptr;
  RoundOptions options_;
  BlockBand<kBlock> system_;
  std::vector<double> feed_, tolerance_, length_, scratch_;
};

template <int D>
bool NewtonRound<D>::solve(const MotionWindow<D>& m, const RoundOptions& options) {
  m_ = &m;
  options_ = options;
  read_path();
  const std::size_t n = m.size();
  system_.reset(n);
  add_regular();
  visit_limits([&](const Row& r, const double* limit, double norm, int count) {
    Quadratic q;
    const double share = options_.share[r.count - 2];
    Multiplier* at = multipliers.row(r.k, static_cast<std::size_t>(r.count) - 2);
    pull_box(r.value, limit, share, at, q);
    pull_ball(r.value, norm, share, count, at[2 * D], q);
    add(r, q);
  });
  add_pace();
  visit_tube([&](const Row& r, double tol, const Mat& project, Multiplier* at) {
    Quadratic q;
    pull_ball(r.value, tol, options_.share[3], D, *at, q);
    // The diagonal is the same for all coordinates.
    q.gradient = project * q.gradient;
    const Mat half = project * q.rest;
    q.rest.noalias() = (half + q.diagonal[0] * project) * project.transpose();
    q.diagonal.setZero();
    add_bend(r, q);
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

}  // namespace toolpace::detail::tube

#include "toolpace/plan/smooth/newton_rows.h"
#include "toolpace/plan/smooth/newton_steps.h"
#include "toolpace/plan/smooth/newton_sums.h"
