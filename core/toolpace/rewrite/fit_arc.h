#pragma once
/// Arcs and helices through two points of a chain, close to all that lies between.

#include <cstddef>
#include <optional>
#include <vector>

#include "toolpace/rewrite/arc_walk.h"
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

/// An arc or helix between two vertices in one plane, judged as it will be written (arc_walk.h). Its centre is put where the
/// largest distances inwards and outwards are about even.
class ArcFitter {
 public:
  ArcFitter(const Curve& curve, const ArcRules& rules, double tolerance);

  std::optional<FittedArc> fit(int plane, std::size_t first, std::size_t last);

 private:
  std::optional<Flat> guess_centre() const;
  ArcWalk walk(const Flat& centre);
  std::optional<Flat> evened(const Flat& centre, const ArcWalk& walk) const;
  std::optional<FittedArc> finished(const Flat& centre, const ArcWalk& walk) const;

  const Curve& curve_;
  ArcRules rules_;
  double tolerance_;
  int plane_ = 17;
  FlatPoints chain_;  // from the start of the arc, which it counts from
  Flat end_;
  bool is_closed_ = false;  // the end is too close to the start to tell of the centre
  std::vector<double> angles_;
};

/// Points of a curve in a plane, counted from the first.
void flatten(const Curve& curve, const PlaneOfArcs& plane, std::size_t first, std::size_t last, FlatPoints& chain);

/// To whole steps.
Flat rounded(const Flat& centre, double step);

}  // namespace toolpace::detail::rewrite
