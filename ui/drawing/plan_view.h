#pragma once
/// What the window tells those of its parts that show a plan.

#include <optional>

#include "drawing/controlled.h"
#include "drawing/measured_trace.h"
#include "drawing/planned.h"
#include "models/instant.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

/// A part takes of each call what it shows; what it has no use for does nothing.
class PlanView {
 public:
  virtual ~PlanView() = default;

  /// A plan, and the one pinned beside it; either may be none. Told whenever one of them, or a proof, is another: most of it
  /// is what is shown already.
  virtual void showPlans(const Planned& /*plan*/, const Planned& /*pinned*/) {}
  /// The controller that the program runs on, and what it does with it.
  virtual void showController(const ControllerView& /*view*/) {}
  /// What a scope recorded of the plan; null = there is no trace.
  virtual void showTrace(const std::shared_ptr<const MeasuredTrace>& /*trace*/) {}
  /// Where the cursor stands; nothing = there is no plan.
  virtual void showInstant(const std::optional<Instant>& /*instant*/) {}
  virtual void setTheme(const Theme& /*theme*/) {}
  virtual void setUnits(Units /*unit*/) {}
};

}  // namespace toolpace::ui
