#pragma once
/// --advice of `simulate`: what would keep the machine from shaking.

#include <optional>

#include "command_line.h"
#include "job_flags.h"
#include "json.h"
#include "toolpace/tune/vibration_advice.h"

namespace toolpace::cli {

struct AdviceFlags {
  bool is_wanted = false;
  std::optional<double> vibration_um;

  void add_to(Command& command);
  /// Usage errors.
  Result<void> check() const;
  /// Nothing where none is wanted.
  Result<std::optional<VibrationAdvice>> take(const Outcome& outcome) const;
};

Json advice_json(const VibrationAdvice& advice, const AdviceFlags& flags, const JobFlags& given, const Setup& setup);
void print_advice(const VibrationAdvice& advice, const AdviceFlags& flags, const JobFlags& given, const Setup& setup);

}  // namespace toolpace::cli
