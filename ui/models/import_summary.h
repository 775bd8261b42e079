#pragma once
/// What of another controller's settings became part of a machine, and what they left open.

#include <QString>
#include <vector>

#include "toolpace/machine/setup.h"

namespace toolpace::ui {

struct ImportRow {
  QString name;   ///< "Jerk of X", or the key of a machine file
  QString value;  ///< with its unit; empty: nothing was said of it
};

/// Limits of the path and of each axis that the setup says anything about, and other values that differ from those of no
/// machine at all.
std::vector<ImportRow> import_summary(const Setup& setup);

}  // namespace toolpace::ui
