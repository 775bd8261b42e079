#include "toolpace/controller/refusals.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace toolpace {
namespace {

struct GrblError {
  std::string_view code;  ///< of the reader
  int number;
};

// In the order of grbl's numbers; what stands in no row is an invalid statement.
constexpr std::array<GrblError, 25> kGrblErrors = {{{"bad-character", 1},
                                                    {"number-expected", 2},
                                                    {"number-too-large", 2},
                                                    {"number-not-finite", 2},
                                                    {"feed-negative", 4},
                                                    {"g-code-unknown", 20},
                                                    {"m-code-unknown", 20},
                                                    {"g-code-ignored", 20},
                                                    {"m-code-ignored", 20},
                                                    {"g-code-unfollowed", 20},
                                                    {"code-not-in-dialect", 20},
                                                    {"sub-program-unknown", 20},
                                                    {"modal-group-twice", 21},
                                                    {"no-feed", 22},
                                                    {"word-twice", 25},
                                                    {"dwell-without-time", 28},
                                                    {"g10-without-p", 28},
                                                    {"arc-incomplete", 35},
                                                    {"arc-centre-incomplete", 35},
                                                    {"arc-same-point", 33},
                                                    {"arc-radius-differs", 33},
                                                    {"arc-radius-too-small", 34},
                                                    {"arc-radius-zero", 34},
                                                    {"arc-radius-too-large", 34},
                                                    {"word-unused", 36}}};
constexpr int kInvalidStatement = 3;

// grbl's own texts, shortened. @source grbl 1.1, doc/csv/error_codes_en_US.csv
std::string_view text_of_error(int number) {
  switch (number) {
    case 1: return "expected command letter";
    case 2: return "bad number format";
    case 4: return "negative value";
    case 20: return "unsupported or invalid g-code command found in block";
    case 21: return "more than one g-code command from the same modal group found in block";
    case 22: return "feed rate has not yet been set or is undefined";
    case 25: return "repeated g-code word found in block";
    case 28: return "g-code command is missing a required P or L value word";
    case 33: return "motion command target is invalid";
    case 34: return "arc radius value is invalid";
    case 35: return "G2 and G3 arcs require at least one in-plane offset word";
    case 36: return "unused value words found in block";
    default: return "invalid statement";
  }
}

}  // namespace

std::vector<Refusal> refusals(Controller controller, const Reading& reading) {
  std::vector<Refusal> list;
  if (controller != Controller::grbl && controller != Controller::grblhal) return list;
  for (const Diagnostic& d : reading.diagnostics) {
    const auto row =
        std::find_if(kGrblErrors.begin(), kGrblErrors.end(), [&](const GrblError& e) { return e.code == d.code; });
    if (row == kGrblErrors.end() && d.severity != Severity::error) continue;
    const int number = row == kGrblErrors.end() ? kInvalidStatement : row->number;
    // A line is refused once.
    if (!list.empty() && list.back().line == d.where.line) continue;
    list.push_back({d.where.line, number, std::string(text_of_error(number))});
  }
  return list;
}

}  // namespace toolpace
