#pragma once
/// Keys of machine files as people call them.

#include <QString>
#include <string>

namespace toolpace::ui {

/// "axes.X.max_jerk_mm_s3" -> "Jerk of X"; the key itself where it is unknown.
QString parameter_name(const std::string& key);

}  // namespace toolpace::ui
