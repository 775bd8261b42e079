#include "toolpace/tune/what_if.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "toolpace/machine/controller_machine.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {
namespace {

constexpr double kTenth = 0.1;
constexpr double kSame = 1e-9;  // relative

/// Values worth trying, in the file's unit.
std::vector<double> values_to_try(const ControllerParameter& p) {
  const double now = *p.value / p.size;
  std::vector<double> values = p.others;
  if (*p.unit != '\0' && std::isfinite(now) && now > 0) {
    values.insert(values.end(), {now * (1 + kTenth), now * (1 - kTenth), next_round_value(now)});
  }
  std::erase_if(values,
                [&](double v) { return v < p.least || v > p.most || std::abs(v - now) <= kSame * std::abs(now); });
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(),
                           [](double a, double b) { return std::abs(a - b) <= kSame * std::abs(a); }),
               values.end());
  return values;
}

}  // namespace

bool is_built_in_setting(const ControllerParameter& p) {
  const std::string_view unit = p.unit;
  return unit == "1/mm" || unit == "blocks" || unit == "ns" || unit == "cycles";
}

double next_round_value(double value) {
  constexpr std::array<double, 11> kRound = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
  const double power = std::pow(10.0, std::floor(std::log10(value) + kSame));
  for (const double round : kRound) {
    if (round * power > value * (1 + kSame)) return round * power;
  }
  return kRound.back() * power * kRound[1];
}

Result<std::vector<WhatIf>> what_if(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                                    const PredictOptions& options, const Monitor& monitor) {
  ControllerSettings tried = settings;
  PredictOptions plain = options;
  plain.keeps_blocks = plain.keeps_motion = false;
  std::vector<WhatIf> rows;
  const std::vector<ControllerParameter> table = parameters(tried);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const ControllerParameter& p = table[i];
    monitor.report(static_cast<double>(i) / static_cast<double>(table.size()));
    if (is_built_in_setting(p)) continue;
    const double before = *p.value;
    for (const double value : values_to_try(p)) {
      *p.value = value * p.size;
      const auto prediction = predict(reading, text, tried, plain, {monitor.stop, {}});
      if (!prediction && prediction.error().kind == ErrorKind::cancelled) return tl::unexpected(prediction.error());
      if (prediction) rows.push_back({p.key, p.title, p.unit, before / p.size, value, prediction->cycle_time});
    }
    *p.value = before;
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const WhatIf& a, const WhatIf& b) { return a.cycle_time < b.cycle_time; });
  return rows;
}

Result<double> cycle_time_as_setpoints(std::shared_ptr<const Reading> reading, const ControllerSettings& settings,
                                       double tolerance, bool refined, const Monitor& monitor) {
  const Setup setup = controller_setup(settings);
  auto job = std::make_shared<Job>();
  job->program = std::move(reading);
  job->machine = setup.machine;
  job->options = setup.options;
  job->refined = refined;
  job->options.ramps = Ramps::span;
  job->options.corner.rule = CornerRule::blend;
  job->options.corner.tolerance = tolerance;
  const auto outcome = run(std::move(job), monitor);
  if (!outcome) return tl::unexpected(outcome.error());
  return outcome->summary.cycle_time;
}

}  // namespace toolpace
