#pragma once
/// What a person typed wrong, with the nearest thing that would have been right.

#include "toolpace/base/result.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace toolpace::cli {

/// What is wrong with the arguments, where the parser stopped at them.
Error explain_usage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace toolpace::cli
