#pragma once
/// Lathe cycles call a sub-program that describes a contour: its blocks are read, and not executed.

#include <functional>
#include <utility>
#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/diagnostic_log.h"
#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/motion/lathe_contour.h"
#include "toolpace/nc/motion/lathe_cycles.h"

namespace toolpace::nc {

class ContourCalls {
 public:
  /// @param run_next_line  runs the program on by a line; false where there is nothing more to run
  ContourCalls(Context& context, Flow& flow, const DiagnosticLog& log, std::function<bool()> run_next_line)
      : context_(context), flow_(flow), log_(log), run_next_line_(std::move(run_next_line)) {}

  /// Runs the lathe cycle `code` of the block.
  bool turn(const Block& block, Code code);
  /// The same of Fanuc's kind: the contour is the lines N<P> to N<Q> of the program itself.
  bool turn_lines(const Block& block, Code code);

  /// Takes the blocks while a contour is read; else null.
  LatheContourReader* reader() { return reader_; }

 private:
  bool read_lines(const Block& block, bool before, std::vector<ContourElement>& contour);
  bool read_contour(const Block& block, const LatheCycle& cycle, std::vector<ContourElement>& contour);

  Context& context_;
  Flow& flow_;
  const DiagnosticLog& log_;
  std::function<bool()> run_next_line_;
  LatheContourReader* reader_ = nullptr;
};

}  // namespace toolpace::nc
