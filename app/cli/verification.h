#pragma once
/// How the command line shows what verification found.

#include "json.h"

#include "toolpace/verify/report.h"

namespace toolpace::cli {

/// The report as JSON, every value in the unit its key names; unlimited = null.
Json verification_json(const VerifyReport& report);

/// A table of the checks for people, on stdout.
void print_verification(const VerifyReport& report);

}  // namespace toolpace::cli
