#pragma once
/// In what two jobs differ, as people read it.

#include <QString>
#include <vector>

#include "models/units.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

struct SettingDifference {
  QString title;  ///< "Acceleration of the path"
  QString a, b;   ///< values with their units
};

/// Program, law, look-ahead, ramps, corners and every number of a machine file or a job; empty where both are the same.
std::vector<SettingDifference> setting_differences(const Job& a, const Job& b, Units units);

/// Whether two jobs run one program with the same settings.
bool has_same_settings(const Job& a, const Job& b);

}  // namespace toolpace::ui
