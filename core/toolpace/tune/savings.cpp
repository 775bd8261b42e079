#include "toolpace/tune/savings.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/pipeline/many.h"

namespace toolpace {
namespace {

struct Trial {
  std::string section, key;
};

bool is_limit(const NumberKey& key, const PlanOptions& options) {
  const auto starts = [&](const char* text) { return key.name.rfind(text, 0) == 0; };
  if (starts("max_")) return std::isfinite(*key.value);
  if (starts("tacc") || starts("tdec")) return law_row(options.law).uses_time;
  if (key.name == "junction_deviation_mm") return options.corner.rule == CornerRule::junction;
  if (key.name == "tolerance_mm") {
    return options.corner.rule == CornerRule::blend || options.corner.rule == CornerRule::smooth;
  }
  return false;
}

std::vector<Trial> trials_of(const Job& job) {
  Setup setup{job.machine, job.options};
  std::vector<Trial> trials;
  for (const SetupSection& section : setup_sections(setup)) {
    for (const NumberKey& key : section.numbers) {
      if (is_limit(key, job.options)) trials.push_back({section.name, key.name});
    }
  }
  if (job.options.feed_override < 2) trials.push_back({"", "feed_override_percent"});
  return trials;
}

/// Raises one value of the setup. @return the value before and after, in the key's unit
std::pair<double, double> raise(Setup& setup, const Trial& trial, double factor) {
  if (trial.section.empty()) {
    const double before = setup.options.feed_override;
    setup.options.feed_override = std::min(2.0, before * factor);
    return {before * 100, setup.options.feed_override * 100};
  }
  for (const SetupSection& section : setup_sections(setup)) {
    if (section.name != trial.section) continue;
    for (const NumberKey& key : section.numbers) {
      if (key.name != trial.key) continue;
      const double before = *key.value / key.unit;
      const bool is_time = trial.section == "law";
      const double raised = is_time ? *key.value / factor : *key.value * factor;
      *key.value = std::clamp(raised, key.range.least * key.unit, key.range.most * key.unit);
      return {before, *key.value / key.unit};
    }
  }
  return {0, 0};
}

}  // namespace

Result<std::vector<Saving>> find_savings(const Job& job, double cycle_time, double factor, const Monitor& monitor) {
  const auto trials = trials_of(job);
  const auto try_one = [&](std::size_t i, const Monitor& quiet) -> Result<Saving> {
    Setup setup{job.machine, job.options};
    const auto [before, after] = raise(setup, trials[i], factor);
    auto raised = std::make_shared<Job>(job);
    raised->machine = setup.machine;
    raised->options = setup.options;
    auto outcome = run(raised, quiet);
    if (!outcome) return tl::unexpected(outcome.error());
    const std::string name = trials[i].section.empty() ? trials[i].key : trials[i].section + "." + trials[i].key;
    return Saving{name, before, after, cycle_time - outcome->summary.cycle_time};
  };
  auto savings = for_many<Saving>(trials.size(), kPlansAtOnce, monitor, try_one);
  if (!savings) return savings;
  std::stable_sort(savings->begin(), savings->end(),
                   [](const Saving& a, const Saving& b) { return a.saved > b.saved; });
  return savings;
}

}  // namespace toolpace
