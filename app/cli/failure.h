#pragma once
/// How a command ends: with an exit code, or with what kept it from its work.

#include <tl/expected.hpp>
#include <utility>

#include "toolpace/base/result.h"

namespace toolpace::cli {

enum ExitCode : int { kFine = 0, kLimitBroken = 1, kBadUsage = 2, kBadInput = 3, kFileTrouble = 4, kInterrupted = 130 };

/// An error, and for a refused program all that is wrong with it. Commands hand it up; main tells people and scripts.
struct Failure {
  Error error;
  Diagnostics diagnostics = {};  ///< on stderr already

  Failure(Error e) : error(std::move(e)) {}  // an Error alone is a Failure, too
  Failure(Error e, Diagnostics d) : error(std::move(e)), diagnostics(std::move(d)) {}
};

using Done = tl::expected<ExitCode, Failure>;

inline Error usage_error(std::string code, std::string message, std::string remedy) {
  return {ErrorKind::usage, std::move(code), std::move(message), std::move(remedy), {}, {}};
}

}  // namespace toolpace::cli
