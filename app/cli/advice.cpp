#include "advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "failure.h"
#include "interrupt.h"
#include "setting_flags.h"
#include "toolpace/base/numbers.h"
#include "toolpace/sample/shaper_band.h"

namespace toolpace::cli {
namespace {

constexpr double kThousandth = 1e-3;  // of mm or deg
constexpr double kLargestResidual = 1e6;

std::string name_of(const CalmChoice& choice) {
  switch (choice.by) {
    case CalmBy::five_phase: return "five-phase ramps";
    case CalmBy::seven_phase: return "seven-phase ramps";
    case CalmBy::quintic: return "quintic ramps";
    case CalmBy::shaper: return "shaper " + std::string(shaper_name(choice.job->options.shaper));
    case CalmBy::nothing: break;
  }
  return "as it is";
}

std::vector<SettingFlag> settings_of(const CalmChoice& choice, const JobFlags& given, const Setup& setup) {
  return setting_flags(given, setup, {choice.job->machine, choice.job->options});
}

constexpr double kRobust = 0.05;  // of a vibration: what is left of it within the band

/// Of a shaper: how wrong the frequencies of the modes may be, as shares of them, each alone.
Json band_json(const CalmChoice& choice) {
  if (choice.by != CalmBy::shaper) return nullptr;
  const auto& servo = choice.job->machine.servo;
  const Impulses impulses = shaping(choice.job->options.shaper, servo);
  ShaperBand narrowest{0, INFINITY};
  for (const AxisMode& m : shaped_modes(servo)) {
    const ShaperBand band = shaper_band(impulses, m.frequency, m.damping, kRobust);
    narrowest = {std::max(narrowest.low, band.low), std::min(narrowest.high, band.high)};
  }
  Json band = Json::array();
  band.push_back(narrowest.low);
  band.push_back(narrowest.high);
  return band;
}

/// [[share of the frequency, what is left of the vibration], …] where all modes are that much slower or faster than they are taken to be:
/// the most of them. Null of what is no shaper.
Json robustness_json(const CalmChoice& choice) {
  constexpr int kFrom = 50, kTo = 150, kStep = 5;  // [%]
  const Job& job = *choice.job;
  if (choice.by != CalmBy::shaper) return nullptr;
  const Impulses impulses = shaping(job.options.shaper, job.machine.servo);
  Json curve = Json::array();
  for (int percent = kFrom; percent <= kTo; percent += kStep) {
    double most = 0;
    for (const AxisMode& m : shaped_modes(job.machine.servo))
      most = std::max(most, residual_share(impulses, m.frequency * percent / 100, m.damping));
    Json point = Json::array();
    point.push_back(percent / 100.0);
    point.push_back(most);
    curve.push_back(std::move(point));
  }
  return curve;
}

Json choice_json(const CalmChoice& choice, const VibrationAdvice& advice, const AdviceFlags& flags,
                 const JobFlags& given, const Setup& setup) {
  const double residual = choice.residual / kThousandth;
  return {{"by", name_of(choice)},
          {"cycle_time_s", choice.cycle_time},
          {"costs_s", choice.cycle_time - advice.present.cycle_time},
          {"residual_um", residual},
          {"band_5_percent", band_json(choice)},
          {"robustness", robustness_json(choice)},
          {"keeps", flags.vibration_um ? Json(residual <= *flags.vibration_um) : Json(nullptr)},
          {"settings", to_json(settings_of(choice, given, setup))}};
}

}  // namespace

void AdviceFlags::add_to(Command& command) {
  command.toggle(
      "--advice", is_wanted,
      "Tell what would keep axes with modes from shaking: ramp times and jerks that suit the modes, and shapers, "
      "each\nplanned and measured, with what it costs");
  command.number(
      "--vibration-um UM", vibration_um,
      "With --advice: the residual after stops that is fine (a rotary axis: in thousandths of a degree); of each "
      "kind\nthe fastest that keeps it is told; default: the one that leaves least");
}

Result<void> AdviceFlags::check() const {
  if (!vibration_um) return {};
  if (!is_wanted)
    return tl::unexpected(usage_error("bad-flag", "--vibration-um is a limit for --advice", "add --advice"));
  if (*vibration_um > 0 && *vibration_um <= kLargestResidual) return {};
  return tl::unexpected(usage_error(
      "bad-flag", fmt::format("--vibration-um is {}, but it must be above 0 and at most 1e6 µm", *vibration_um), ""));
}

Result<std::optional<VibrationAdvice>> AdviceFlags::take(const Outcome& outcome) const {
  if (!is_wanted) return std::nullopt;
  std::optional<double> limit;
  if (vibration_um) limit = *vibration_um * kThousandth;
  auto advice = advise_on_vibration(outcome.job, limit, terminal_monitor("advising"));
  end_progress();
  if (!advice) return tl::unexpected(advice.error());
  return std::optional(*std::move(advice));
}

Json advice_json(const VibrationAdvice& advice, const AdviceFlags& flags, const JobFlags& given, const Setup& setup) {
  Json choices = Json::array();
  for (const CalmChoice& c : advice.choices) choices.push_back(choice_json(c, advice, flags, given, setup));
  return {
      {"limit_um", flags.vibration_um ? Json(*flags.vibration_um) : Json(nullptr)},
      {"present", choice_json(advice.present, advice, flags, given, setup)},
      {"choices", std::move(choices)},
      {"best", advice.best ? choice_json(advice.choices[*advice.best], advice, flags, given, setup) : Json(nullptr)}};
}

void print_advice(const VibrationAdvice& advice, const AdviceFlags& flags, const JobFlags& given, const Setup& setup) {
  fmt::print("  vibration       {:.4g} µm after stops{}\n", advice.present.residual / kThousandth,
             flags.vibration_um ? fmt::format(", {:.4g} µm wanted", *flags.vibration_um) : "");
  for (std::size_t i = 0; i < advice.choices.size(); ++i) {
    const CalmChoice& c = advice.choices[i];
    fmt::print("  {} {:<18} leaves {:>9.4g} µm, costs {:>8.3f} s: {}\n", advice.best == i ? '*' : ' ', name_of(c),
               c.residual / kThousandth, c.cycle_time - advice.present.cycle_time,
               to_text(settings_of(c, given, setup)));
  }
}

}  // namespace toolpace::cli
