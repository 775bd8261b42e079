#pragma once
/// Writes a plan's setpoints to a file.

#include <QString>

#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// The extension chooses the format; the file appears whole or not at all. Errors: usage (unknown format), io, cancelled.
/// @return rows written
Result<std::size_t> write_setpoints(const Outcome& outcome, const QString& file, const Monitor& monitor = {});

}  // namespace toolpace::ui
