#pragma once
/// Executes a block: its codes and words in the fixed order of RS-274/NGC.

#include "toolpace/nc/context.h"
#include "toolpace/nc/contour_calls.h"
#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/macro_calls.h"

namespace toolpace::nc {

class Executor {
 public:
  Executor(Context& context, Flow& flow, ContourCalls& contours)
      : context_(context), flow_(flow), contours_(contours), macros_(flow, context.faults) {}

  /// @return false after recording a fault
  bool run(const Block& block);

  /// After M2, M30 and the like.
  bool has_ended() const { return ended_; }

 private:
  bool run_in_order(const Block& block);
  bool run_any_motion(const Block& block, Code motion);
  bool run_machine_codes(const Block& block);
  bool run_saved_state(Code code);
  bool run_dwell(const Block& block);
  bool run_stop(const Block& block);
  bool run_subprogram_code(const Block& block);
  bool begin_at(const Block& block, int times);

  Context& context_;
  Flow& flow_;
  ContourCalls& contours_;
  MacroCalls macros_;
  bool ended_ = false;
};

}  // namespace toolpace::nc
