#pragma once
/// How the command line shows what verification found.

#include "json.h"

#include "toolpace/verify/report.h"

namespace toolpace::cli {

/// The report as JSON, every value in the unit its key names; unlimited = null.
Json verification_json(const VerifyReport& report);

/// A table of the checks for people, on stdout.
void print_verification(const VerifyReport& report);

/// "X speed", "deviation from the path", …
std::string check_title(const Check& check);
/// Unit of a check's value at the edge: "mm/s", "deg", …; with factor from the core's unit.
struct CheckUnit {
  const char* symbol;
  const char* suffix;  ///< of JSON keys: "mm_s"
  double factor;
};
CheckUnit check_unit(const Check& check);

}  // namespace toolpace::cli
