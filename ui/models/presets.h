#pragma once
/// Ways of planning that have a name: sets of options to begin with.

#include <QString>
#include <array>

#include "toolpace/plan/options.h"

namespace toolpace::ui {

struct PlanPreset {
  const char* id;
  QString (*title)();  ///< with its source, in the language of the window
  QString (*tip)();
  void (*apply)(PlanOptions& options);  ///< leaves overrides, holds, tolerances and times as they are
};

/// Limits are left as they are: they are the machine's.
const std::array<PlanPreset, 4>& plan_presets();

}  // namespace toolpace::ui
