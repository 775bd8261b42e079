#pragma once
/// Slacks and prices of all limits of a window: what a primal-dual interior-point method remembers between its steps.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "toolpace/plan/smooth/motion_window.h"

namespace toolpace::detail::tube {

/// One limit "use ≤ 1": use − 1 + slack = 0 and slack·price = weight hold where the method has arrived.
///
/// A limit that is broken keeps a slack of its own and is approached by Newton's method, from outside; so, other than with
/// a barrier, it does not stand in the way of its neighbours' steps.
/// @source Wright 1997, "Primal-Dual Interior-Point Methods", chapter 6 (infeasible start)
struct Multiplier {
  double slack = 0, price = 0;  ///< price 0: not met yet
  double slack_step = 0;

  static constexpr double kFirstSlack = 0.3;  // of a limit that is broken when it is first met
  static constexpr double kBack = 0.98;       // share of the way to slack 0 that a step may go
  static constexpr double kSpread = 1e6;      // of slack·price about the weight
  static constexpr double kLeastSlack = 0.3;  // of a limit that is broken, as a share of the excess

  /// Slope and curvature of what a limit adds to the Newton system, by its use.
  struct Pull {
    double slope, curvature;
  };
  Pull pull(double use, double weight) {
    if (price == 0) {
      slack = std::max(1 - use, kFirstSlack);
      price = weight / slack;
    }
    slack = std::max({slack, 1 - use, kLeastSlack * (use - 1)});
    const double by = 1 / slack, curvature = price * by;
    return {weight * by + curvature * (use - 1 + slack), curvature};
  }
  /// @return share of the step that keeps the slack positive
  double aim(double use, double change) {
    slack_step = 1 - use - slack - change;
    return slack_step < -kBack * slack ? -kBack * slack / slack_step : 1.0;
  }
  void step(double share, double weight) {
    const double to = (weight - price * slack_step) / slack;
    slack += share * slack_step;
    price = std::max(to, (1 - kBack) * price);
    const double central = weight / slack;
    price = std::clamp(price, central / kSpread, central * kSpread);
  }
};

/// The multipliers of a window: of each limit row 2·D for the axes and one for the vector, of each tube station, and of each
/// vertex.
template <int D>
class Multipliers {
 public:
  static constexpr std::size_t kRow = 2 * D + 1;

  void reset(std::size_t points, std::size_t vertices, int samples) {
    samples_ = static_cast<std::size_t>(samples);
    all_.assign(points * stride(), {});
    vertex_.assign(vertices, {});
    place_.assign(vertices, 0);
  }

  Multiplier* row(std::size_t k, std::size_t order) { return all_.data() + k * stride() + order * kRow; }
  Multiplier* station(std::size_t k, std::size_t i) { return all_.data() + k * stride() + 3 * kRow + i; }
  /// @param k  where the vertex is passed now
  Multiplier* vertex(std::size_t i, std::size_t k) {
    place_[i] = k;
    return vertex_.data() + i;
  }

  void step(const std::vector<double>& share, double weight) {
    Multiplier* at = all_.data();
    for (std::size_t k = 0; k * stride() < all_.size(); ++k) {
      for (std::size_t i = 0; i < stride(); ++i, ++at) {
        if (at->price > 0) at->step(share[k], weight);
      }
    }
    for (std::size_t i = 0; i < vertex_.size(); ++i) {
      if (vertex_[i].price > 0) vertex_[i].step(share[place_[i]], weight);
    }
  }

  /// After each step was made two. Stations are met anew.
  void halve(std::size_t points, int samples) {
    const std::size_t old = stride();
    samples_ = static_cast<std::size_t>(samples);
    moved_.assign(points * stride(), {});
    for (std::size_t j = 0; j < points; ++j) {
      std::copy_n(all_.data() + (j + 1) / 2 * old, 3 * kRow, moved_.data() + j * stride());
    }
    all_.swap(moved_);
  }

  /// Takes those of a part of a motion from those of the whole.
  /// @param point, vertex  of the whole, where the part begins
  void take(const Multipliers& whole, std::size_t point, std::size_t vertex) {
    std::copy_n(whole.all_.data() + point * stride(), all_.size(), all_.data());
    std::copy_n(whole.vertex_.data() + vertex, vertex_.size(), vertex_.data());
  }
  /// Puts those of a part back into the whole.
  void put(const Multipliers& part, std::size_t point, std::size_t vertex) {
    std::copy_n(part.all_.data(), part.all_.size(), all_.data() + point * stride());
    std::copy_n(part.vertex_.data(), part.vertex_.size(), vertex_.data() + vertex);
  }

  /// After a change of pace: what point j of the new motion was.
  void move(const std::vector<std::size_t>& was) {
    moved_.resize(was.size() * stride());
    for (std::size_t j = 0; j < was.size(); ++j) {
      std::copy_n(all_.data() + was[j] * stride(), stride(), moved_.data() + j * stride());
    }
    all_.swap(moved_);
  }

 private:
  std::size_t stride() const { return 3 * kRow + samples_; }

  std::size_t samples_ = 1;
  std::vector<Multiplier> all_, moved_, vertex_;
  std::vector<std::size_t> place_;
};

}  // namespace toolpace::detail::tube
