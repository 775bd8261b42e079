#pragma once
/// What a person typed wrong, with the nearest thing that would have been right.

#include <CLI/CLI.hpp>

namespace toolpace::cli {

/// Prints help and version where they were asked for, else what is wrong with the arguments.
/// @return the exit code
int report_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace toolpace::cli
