#pragma once
/// The contour of a lathe cycle (G70 … G72.2), turned so that every cycle sees it alike.
///
/// In a profile x falls from the first element to the last and y is the level: the material lies above the contour. What the
/// machine calls X and Z, outside or inside, towards the chuck or away from it, is a matter of mirrors and a quarter turn.

#include <cstdint>
#include <vector>

#include "toolpace/nc/fault.h"
#include "toolpace/nc/motion/offset_geometry.h"

namespace toolpace::nc {

inline constexpr double kVanishing = 1e-3;  ///< [program unit] shorter elements of a contour are dropped

/// A line or an arc of at most half a turn, and the program's line that it stands in.
struct ContourElement : OffsetElement {
  std::uint32_t line = 0;
  bool rapid = false;  ///< the program goes along it by G0
  double feed = 0.0;   ///< F that the contour gives for it, in the program's units; 0 = none
};

/// How much a cycle may still calculate: contours and passes multiply.
class WorkBudget {
 public:
  explicit WorkBudget(std::size_t steps) : left_(steps) {}
  bool spend(std::size_t steps = 1) {
    left_ -= steps < left_ ? steps : left_;
    return left_ > 0;
  }
  std::size_t left() const { return left_; }

 private:
  std::size_t left_;
};

class LatheProfile {
 public:
  /// @param contour  first the way from the cycle's start to the contour, then the contour; x is Z, y is X, at least 2
  /// @param facing   true: passes run along X (G72)
  /// @param unit     [mm] of the program's unit of length, which LinuxCNC's tolerances count in
  LatheProfile(std::vector<ContourElement> contour, bool facing, double unit);

  const std::vector<ContourElement>& elements() const { return elements_; }
  double unit() const { return unit_; }

  Point in_machine(Point p) const;
  /// The way back, of a difference of two points.
  Point from_machine(Point difference) const;
  /// Sense of an arc in the machine's XZ plane.
  int turn_in_machine(int turn) const { return mirrors_along_ != mirrors_level_ ? -turn : turn; }

  /// @return the first element, the way in left out, that goes back on x or has a crest or bottom of its own within; or null
  const ContourElement* find_turning_back() const;

  /// Begins above the contour's start where the cycle starts short of it.
  void start_above();

  /// Moves the contour by `distance` [mm] away from the material's other side; corners that open get an arc.
  bool widen(double distance, WorkBudget& budget, FaultSink& faults);

  void shift(Point by);

  /// Leads the end up to the level that the cycle starts at.
  void close();

 private:
  bool lies_below(double start, double way) const;
  void mirror_level();
  void mirror_along();
  bool widen_step(std::vector<ContourElement>& contour, double step, WorkBudget& budget) const;
  void fill_corners(std::vector<ContourElement>& contour, double step) const;
  bool trim(std::vector<ContourElement>& contour, WorkBudget& budget) const;
  bool goes_on(const ContourElement& element) const;

  std::vector<ContourElement> elements_;
  double unit_;
  bool facing_;
  bool mirrors_along_ = false, mirrors_level_ = false;
};

}  // namespace toolpace::nc
