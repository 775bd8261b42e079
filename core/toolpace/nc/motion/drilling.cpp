#include "toolpace/nc/motion/drilling.h"

#include <fmt/format.h>

#include <algorithm>

#include "toolpace/nc/motion/cycle_fault.h"
#include "toolpace/nc/scaling.h"

namespace toolpace::nc {
namespace {

constexpr double kPeckClearance = 0.254;  // [mm] 0.010 in, of G73 and G83

// Pecks are lengths in the machine, whatever the scale. They may shrink by J from one to the next, down to K.
void peck(CycleRun& run, const Hole& hole, double scale, const CycleMemory& memory, bool full_retract) {
  double step = memory.peck / scale;
  const double least = std::min(memory.k / scale, step), less = memory.j / scale;
  for (double depth = hole.retract - step; depth > hole.bottom; depth -= step) {
    if (less > 0.0) step = std::max(least, step - less);
    run.feed(depth);
    if (full_retract) run.rapid(hole.retract);
    run.rapid(depth + kPeckClearance / scale);
  }
  run.feed(hole.bottom);
  run.rapid(hole.clear);
}

bool check_spindle(Context& context, const Block& block, Code code) {
  const int direction = context.state.modal.spindle_direction;
  const bool needs_any = code == 860 || code == 870 || code == 880;
  const int wanted = code == 740 ? -1 : code == 840 ? 1 : 0;
  if (needs_any && direction == 0 && context.rules.refuses_doubtful) {
    return fail(context, block, "spindle-stopped", code_text('G', code) + " while the spindle stands still",
                "start it with M3 or M4");
  }
  if (wanted == 0 || wanted == direction || !context.rules.refuses_doubtful) return true;
  return fail(context, block, "spindle-direction",
              fmt::format("{} while the spindle does not turn that way", code_text('G', code)),
              wanted > 0 ? "start it with M3 before G84" : "start it with M4 before G74");
}

// Back boring: down beside the hole, sideways into it, up to `top` with the tool, and all of it back.
void back_bore(CycleRun& run, const Hole& hole, const CycleMemory& memory, double top) {
  const double beside_first = hole.first + memory.i, beside_second = hole.second + memory.j;
  run.rapid_to(beside_first, beside_second);
  run.rapid(hole.bottom);
  run.rapid_to(hole.first, hole.second);
  run.feed(top);
  run.feed(hole.bottom);
  run.rapid_to(beside_first, beside_second);
  run.rapid(hole.clear);
  run.rapid_to(hole.first, hole.second);
}

// Fine boring: off the wall at the bottom, and out along the hole.
void bore_finely(CycleRun& run, const Hole& hole, const CycleMemory& memory) {
  run.feed(hole.bottom);
  run.dwell(memory.dwell);
  if (memory.i != 0.0 || memory.j != 0.0) run.rapid_to(hole.first + memory.i, hole.second + memory.j);
  run.rapid(hole.clear);
  run.rapid_to(hole.first, hole.second);
}

}  // namespace

void CycleRun::rapid_to(double first, double second, double at_level) {
  Position end = context_.state.position;
  end[plane_.normal] = at_level;
  end[plane_.first] = first;
  end[plane_.second] = second;
  context_.out.line(MoveKind::rapid, context_.state.offsets, end);
  context_.state.position = end;
}

void CycleRun::move(MoveKind kind, double level) {
  Position end = context_.state.position;
  end[plane_.normal] = level;
  context_.out.line(kind, context_.state.offsets, end, feed_);
  context_.state.position = end;
}

void bore_back(Context& context, CycleRun& run, const Hole& hole) {
  const CycleMemory& memory = context.state.cycle;
  const double beside_first = hole.first + memory.i, beside_second = hole.second + memory.j;
  run.rapid_to(beside_first, beside_second);
  run.rapid(hole.retract);
  run.rapid_to(hole.first, hole.second);
  run.feed(hole.bottom);
  run.dwell(memory.dwell);
  run.rapid_to(beside_first, beside_second);
  run.rapid(hole.clear);
  run.rapid_to(hole.first, hole.second);
}

bool drill(Context& context, CycleRun& run, const Block& block, const Hole& hole, Code code) {
  const CycleMemory& memory = context.state.cycle;
  if (!check_spindle(context, block, code)) return false;
  const bool incremental = context.state.modal.incremental();
  const bool as_linuxcnc = context.rules.linuxcnc_cycles;
  switch (code) {
    case 730:
    case 830: peck(run, hole, scale_of(context.state.offsets, hole.plane.normal), memory, code == 830); return true;
    case kFineBoring: bore_finely(run, hole, memory); return true;
    case 870: back_bore(run, hole, memory, memory.k + (incremental ? hole.bottom : 0.0)); return true;
    case 880:  // the operator retracts by hand
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      context.out.note(MoveKind::stop, "M0");
      if (as_linuxcnc) context.state.position[hole.plane.normal] = hole.clear;
      return true;
    case 810: run.feed(hole.bottom); break;
    case 820:
    case 860:
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      break;
    case 850:
      run.feed(hole.bottom);
      run.feed(hole.retract);
      break;
    case 740:
    case 840:  // tapping: the spindle turns round at the bottom
    case 890:
      run.feed(hole.bottom);
      run.dwell(memory.dwell);
      run.feed(as_linuxcnc ? hole.clear : hole.retract);
      break;
    default: break;
  }
  run.rapid(hole.clear);
  return true;
}

}  // namespace toolpace::nc
