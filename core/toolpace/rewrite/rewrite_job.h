#pragma once
/// A program rewritten for a machine, or for a real controller, with the times before and after.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "toolpace/controller/prediction.h"
#include "toolpace/machine/setup.h"
#include "toolpace/rewrite/rewrite.h"

namespace toolpace {

/// What the program is for, and what may become of it.
struct RewriteTarget {
  Setup setup;  ///< options.corner.tolerance is how far the new path may be from the old one
  std::optional<ControllerSettings>
      settings;  ///< times and feeds are those of this controller; none: of the plan on the setup
  PredictOptions predict;
  bool wants_arcs = true;  ///< arcs and helices, where the controller has them; else lines alone
  bool plans_feeds = false;
};

struct RewrittenFor {
  Rewritten rewritten;  ///< with both times
  ProgramTime before, after;
};

/// Checks the tolerance, rewrites, and takes the times: of the controller's model, by which parts that would take longer are left as
/// they were, or else of two plans.
/// @param reading  of `text`, as read_text(text, name, read_options) has it
/// Errors: usage (bad-limit) for a tolerance of 0; of rewrite(), predict() and run().
Result<RewrittenFor> rewrite_for(const RewriteTarget& target, std::string_view text, const std::string& name,
                                 const std::shared_ptr<const Reading>& reading, const ReadOptions& read_options,
                                 const Monitor& monitor = {});

/// Rows that move.
std::size_t motion_rows(const Moves& moves);

}  // namespace toolpace
