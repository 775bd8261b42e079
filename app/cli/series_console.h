#pragma once
/// What one command of a series says, kept.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "console.h"

namespace toolpace::cli {

/// In the place of the terminal for one program of many.
class SeriesConsole final : public Console {
 public:
  explicit SeriesConsole(std::stop_token stop) : stop_(std::move(stop)) {}

  void tell(std::string_view text) override { told += text; }
  void answer(const Json& json) override { answered = json; }
  Monitor monitor(const char*) override { return {stop_, {}}; }
  void has_read(const Reading& reading) override {
    files = reading.moves.files;
    const auto error = std::find_if(reading.diagnostics.begin(), reading.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::error; });
    if (error != reading.diagnostics.end()) first_error = *error;
  }
  const Outcome* before() const override { return nullptr; }
  void planned(Outcome, const std::optional<Chain>&) override {}
  void pulsed(const PulseTable&) override {}

  std::string told;
  Json answered;                          ///< null = it printed nothing
  std::vector<std::string> files;         ///< of the program that was read, itself first
  std::optional<Diagnostic> first_error;  ///< of what was read

 private:
  std::stop_token stop_;
};

}  // namespace toolpace::cli
