#pragma once
/// Arcs and helices through two points of a chain, close to all that lies between.

#include <cstddef>
#include <optional>
#include <vector>

#include "toolpace/rewrite/curve.h"

namespace toolpace::detail::rewrite {

/// What an arc may be, where it is written, and how finely its centre is.
struct ArcRules {
  bool any_plane = true;      ///< planes other than the active one may be chosen
  bool may_turn_on = false;   ///< several turns in one block (P)
  double most_radius = 1e4;   ///< [mm]
  double centre_step = 1e-4;  ///< [mm] of the last digit of I J K
};

struct FittedArc {
  int plane = 17;
  double i = 0.0,
         j = 0.0;  ///< [mm] from the start to the centre, along the plane's first and second axis; whole centre_steps
  bool clockwise = false;
  int turns = 1;       ///< begun: 1 up to a full turn
  double sweep = 0.0;  ///< [rad] without sign
};

/// An arc or helix between two vertices in one plane, judged as it will be written.
///
/// Its centre is put where the largest distances inwards and outwards are about even. Judged is, place by place, the distance
/// between the chain and the arc at the same angle about the centre, which never goes back: an upper bound of the Fréchet
/// distance, exact but for what a radius that changes by the rounding of the centre adds.
class ArcFitter {
 public:
  ArcFitter(const Curve& curve, const ArcRules& rules, double tolerance);

  std::optional<FittedArc> fit(int plane, std::size_t first, std::size_t last);

 private:
  struct Flat {
    double u, v, w;  // along the plane's first, second and normal axis, from the start of the arc
  };
  struct Centre {
    double u, v;
  };
  /// What was found while walking about a centre.
  struct Walk {
    bool goes_round = false;     // in one sense, each chord by little enough
    bool fits = false;           // and within the tolerance
    double sweep = 0.0;          // [rad] without sign
    double out = 0.0, in = 0.0;  // [mm] farthest outwards and inwards of the arc
    Flat out_at{}, in_at{};      // where
  };

  Flat flat(std::size_t point) const;
  std::optional<Centre> guess_centre(std::size_t begin, std::size_t end) const;
  Centre rounded(const Centre& c) const;
  double sense(const Centre& c, std::size_t begin, std::size_t end) const;
  Walk walk(const Centre& c, std::size_t begin, std::size_t end);
  bool heights_fit(const Centre& c, std::size_t begin, std::size_t end, double slack, double sweep);
  std::optional<Centre> evened(const Centre& c, const Walk& walk) const;
  std::optional<FittedArc> finished(const Centre& c, const Walk& walk, std::size_t end) const;

  const Curve& curve_;
  ArcRules rules_;
  double tolerance_;
  int plane_ = 17;
  Eigen::Index u_ = 0, v_ = 1, w_ = 2;
  Eigen::Vector3d start_;
  Flat end_{};
  bool is_closed_ = false;  // the end is too close to the start to tell of the centre
  double turn_ = 1.0;       // + counter-clockwise
  std::vector<double> angle_;
};

}  // namespace toolpace::detail::rewrite
