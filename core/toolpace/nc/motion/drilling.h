#pragma once
/// What a canned cycle does at one hole.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// One hole, in work coordinates; levels along the plane's normal axis.
struct Hole {
  PlaneAxes plane;
  double first, second;  ///< its place in the plane
  double retract;        ///< R
  double bottom;
  double clear;  ///< level to leave at
};

/// Moves of a cycle along the axes of its plane.
class CycleRun {
 public:
  CycleRun(Context& context, const PlaneAxes& plane, const Feedrate& feed)
      : context_(context), plane_(plane), feed_(feed) {}

  void rapid(double level) { move(MoveKind::rapid, level); }
  void feed(double level) { move(MoveKind::feed, level); }
  void rapid_to(double first, double second) { rapid_to(first, second, context_.state.position[plane_.normal]); }
  void rapid_to(double first, double second, double at_level);
  void dwell(double seconds) { context_.out.dwell(seconds); }

 private:
  void move(MoveKind kind, double level);

  Context& context_;
  PlaneAxes plane_;
  Feedrate feed_;
};

/// Drills a hole; the tool stands over it at R. Words that stick are those of state.cycle.
bool drill(Context& context, CycleRun& run, const Block& block, const Hole& hole, Code code);

/// G87 of Fanuc's kind: R lies below; the tool goes there beside the hole and bores upwards. It stands at `clear`.
void bore_back(Context& context, CycleRun& run, const Hole& hole);

}  // namespace toolpace::nc
