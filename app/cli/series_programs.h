#pragma once
/// Which programs a series has.

#include <string>
#include <vector>

#include "series.h"

namespace toolpace::cli {

/// Those that were named, those of folders (by the endings of NC programs, sorted, not of folders within), and those of the list, a
/// line each; each of them once. Errors: usage (there are none, or standard input is one of them), io.
Result<std::vector<std::string>> programs_of(const SeriesFlags& flags);

/// "out/{}.npz" for a program: {} is its name without folder and ending.
std::string filled(const std::string& pattern, const std::string& program);

/// Errors (usage): an output without {} for several programs; two that are one file, or a file that is read.
Result<void> check_series_outputs(const Series& series, const std::vector<std::string>& programs);

}  // namespace toolpace::cli
