#pragma once
/// Two arcs between two points that leave and arrive in given directions, and pass into each other without a corner.

#include <optional>

#include "toolpace/rewrite/fit_arc.h"

namespace toolpace::detail::rewrite {

/// Where places between the program's own can be written: offset + whole steps, of each axis.
struct PlaceGrid {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< [mm]
  double step = 1e-4;                                ///< [mm]
};

struct FittedBiarc {
  FittedArc first, second;  ///< turns 0: a straight line
  Eigen::Vector3d joint;    ///< [mm] where they meet, on the grid
};

class BiarcFitter {
 public:
  BiarcFitter(const Curve& curve, const ArcRules& rules, const PlaceGrid& grid, double tolerance);

  /// @param leaving, arriving  directions at the two vertices; what they have along the plane's normal is left out
  /// @source Bolton 1975, "Biarc curves"; the joint is the one at equal distances from both ends along the directions
  std::optional<FittedBiarc> fit(int plane, std::size_t first, std::size_t last, const Eigen::Vector3d& leaving,
                                 const Eigen::Vector3d& arriving);

 private:
  bool split_at(const Flat& joint);
  Flat on_grid(const Flat& joint) const;
  std::optional<FittedArc> half(const FlatPoints& chain, const Flat& start, const Flat& end, const Flat& at,
                                const Flat& along);

  const Curve& curve_;
  ArcRules rules_;
  PlaceGrid grid_;
  double tolerance_;
  int plane_ = 17;
  PlaneOfArcs axes_;
  Eigen::Vector3d start_;
  FlatPoints chain_, before_, behind_;
  Flat met_;  // where the chain is nearest to the joint
  std::vector<double> angles_;
};

}  // namespace toolpace::detail::rewrite
