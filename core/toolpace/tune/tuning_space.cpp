#include "toolpace/tune/tuning_space.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/strategy.h"

namespace toolpace {
namespace {

constexpr std::array<std::string_view, kKnobCount> kNames = {"law", "corner", "ramps",     "am",
                                                             "jm",  "tacc",   "tolerance", "lookahead"};
constexpr std::size_t kPlaces = 96;  // of a number
// How far below the job's own value a number may be turned, as a factor. A contour error falls with the acceleration, so that a
// tenth of it is found at about a tenth; jerk has more room, as it seldom decides.
constexpr double kSofter = 50, kGentler = 200, kNarrower = 20;
constexpr double kSlowerRamps = 4, kQuickerRamps = 50;  // Tacc is no limit: it goes both ways
constexpr std::size_t kMostDepths = 12;

/// The largest number of three digits that is no larger. @pre value > 0
double rounded_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)) - 2);
  const double digits = std::floor(value / power * (1 + 1e-12));
  // Times or over a whole power of ten: the nearest double to what three digits say.
  return power >= 1 ? digits * std::round(power) : digits / std::round(1 / power);
}

bool is_finite(double limit) { return limit < kUnlimited; }

/// What axes can do together, where the path itself has no limit: along the diagonal of those that have one.
double diagonal(const Machine& machine, double AxisLimits::*limit) {
  double square = 0;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const double one = machine.axes[k].*limit;
    if (!is_rotary(k) && is_finite(one)) square += one * one;
  }
  return std::sqrt(square);
}

bool has_jerk_limit(const Machine& machine) {
  return is_finite(machine.path.jerk) ||
         std::any_of(machine.axes.begin(), machine.axes.end(), [](const AxisLimits& a) { return is_finite(a.jerk); });
}

bool may_try(const LawRow& law, const Job& job) {
  if (law.kind == job.options.law) return true;
  if (has_jerk_limit(job.machine)) return law.bounds_jerk;
  return !law.needs_jerk;
}

/// Turns a limit and its twin, that of slowing down, which stays in the same ratio.
void turn(double& limit, double& twin, double share, double reference) {
  const double before = limit;
  limit = rounded_down((is_finite(before) ? before : reference) * share);
  if (twin == before) {
    twin = limit;
  } else if (!is_finite(before)) {
    twin = std::min(twin, limit);
  } else if (is_finite(twin)) {
    twin = rounded_down(twin * share);
  }
}

void turn_time(double& seconds, double share) {
  constexpr double kMilli = 1e-3;  // as flags and files are read
  seconds = std::max(1e-3, rounded_down(seconds / kMilli * share)) * kMilli;
}

}  // namespace

std::string_view knob_name(Knob knob) { return kNames[static_cast<std::size_t>(knob)]; }

std::optional<Knob> knob_named(std::string_view name) {
  const auto* found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Knob>(found - kNames.begin());
}

std::string knob_names() {
  std::string names;
  for (const std::string_view name : kNames) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

bool TuningSpace::is_choice(Knob knob) { return knob == Knob::law || knob == Knob::corner || knob == Knob::ramps; }

TuningSpace::TuningSpace(std::shared_ptr<const Job> job, std::span<const Knob> turned) : job_(std::move(job)) {
  for (const Knob knob : turned) {
    if (!scale(knob).empty()) continue;
    if (is_choice(knob)) {
      add_choices(knob);
    } else if (knob == Knob::lookahead) {
      add_depths();
    } else {
      add_numbers(knob);
    }
  }
  for (Scale& scale : scales_) {
    if (scale.empty()) scale.push_back({1, 1});
  }
}

void TuningSpace::add_choices(Knob knob) {
  Scale& scale = scales_[static_cast<std::size_t>(knob)];
  const PlanOptions& o = job_->options;
  const auto add = [&](auto choice, auto own) {
    if (choice == own) home_[static_cast<std::size_t>(knob)] = static_cast<std::uint16_t>(scale.size());
    scale.push_back({static_cast<double>(choice), 0});
  };
  if (knob == Knob::law) {
    for (const LawRow& law : law_table()) {
      if (may_try(law, *job_)) add(law.kind, o.law);
    }
  } else if (knob == Knob::ramps) {
    for (const auto& name : ramps_names()) add(name.value, o.ramps);
  } else if (!o.corner.step) {
    for (const auto& name : corner_names()) add(name.value, o.corner.rule);
  }
}

void TuningSpace::add_numbers(Knob knob) {
  const Machine& m = job_->machine;
  double below = kNarrower, above = 1;
  bool is_open = false;  // without a limit of its own: that is one more place
  if (knob == Knob::acceleration) {
    is_open = !is_finite(m.path.acceleration);
    below = kSofter;
    if (is_open && diagonal(m, &AxisLimits::acceleration) == 0) return;
  } else if (knob == Knob::jerk) {
    is_open = !is_finite(m.path.jerk);
    below = kGentler;
    if (is_open && diagonal(m, &AxisLimits::jerk) == 0) return;
  } else if (knob == Knob::ramp_time) {
    below = kQuickerRamps;
    above = kSlowerRamps;
  }
  Scale& scale = scales_[static_cast<std::size_t>(knob)];
  const double length = std::log(below * above);
  std::vector<double> shares;
  for (std::size_t i = 0; i < kPlaces; ++i)
    shares.push_back(std::exp(length * static_cast<double>(i) / (kPlaces - 1)) / below);
  if (above > 1) {
    shares.push_back(1);
    std::sort(shares.begin(), shares.end());
  } else {
    shares.back() = 1;
  }
  for (const double share : shares) {
    if (share == 1 && !is_open) home_[static_cast<std::size_t>(knob)] = static_cast<std::uint16_t>(scale.size());
    scale.push_back({share, std::log(share * below) / length});
  }
  if (!is_open) return;
  home_[static_cast<std::size_t>(knob)] = static_cast<std::uint16_t>(scale.size());
  scale.push_back({kUnlimited, 1 + 1.0 / kPlaces});
}

void TuningSpace::add_depths() {
  const auto& own = job_->options.lookahead;
  const std::size_t blocks = motion_blocks(job_->program->moves);
  const std::size_t most = own ? std::min(*own, blocks) : blocks;
  Scale& scale = scales_[static_cast<std::size_t>(Knob::lookahead)];
  for (std::size_t depth = 1; depth < most && scale.size() < kMostDepths; depth *= 2) {
    scale.push_back({static_cast<double>(depth), static_cast<double>(scale.size()) / kMostDepths});
  }
  home_[static_cast<std::size_t>(Knob::lookahead)] = static_cast<std::uint16_t>(scale.size());
  scale.push_back({kUnlimited, static_cast<double>(scale.size()) / kMostDepths});
}

double TuningSpace::value_at(const Position& position, Knob knob) const {
  return scale(knob)[position[static_cast<std::size_t>(knob)]].value;
}

bool TuningSpace::is_home(const Position& position, Knob knob) const {
  const auto k = static_cast<std::size_t>(knob);
  return position[k] == home_[k];
}

Position TuningSpace::canonical(const Position& position) const {
  Position p = position;
  const auto send_home = [&](Knob knob) { p[static_cast<std::size_t>(knob)] = home_[static_cast<std::size_t>(knob)]; };
  const CornerOptions corner = job_at(p)->options.corner;
  if (corner.rule == CornerRule::smooth && !corner.step) {
    for (const Knob knob : {Knob::law, Knob::ramps, Knob::lookahead}) send_home(knob);
  }
  const LawRow& law = law_row(job_at(p)->options.law);
  if (!law.uses_time) send_home(Knob::ramp_time);
  const bool keeps_jerk = law.bounds_jerk || (corner.rule == CornerRule::smooth && has_jerk_limit(job_->machine));
  if (!keeps_jerk) send_home(Knob::jerk);
  if (corner.step || corner.rule == CornerRule::stop || corner.rule == CornerRule::servo) send_home(Knob::tolerance);
  return p;
}

std::shared_ptr<const Job> TuningSpace::job_at(const Position& position) const {
  auto job = std::make_shared<Job>(*job_);
  PlanOptions& o = job->options;
  PathLimits& path = job->machine.path;
  const auto is_turned = [&](Knob knob) { return !is_home(position, knob); };
  const auto value = [&](Knob knob) { return value_at(position, knob); };
  if (is_turned(Knob::law)) o.law = static_cast<LawKind>(static_cast<int>(value(Knob::law)));
  if (is_turned(Knob::corner)) o.corner.rule = static_cast<CornerRule>(static_cast<int>(value(Knob::corner)));
  if (is_turned(Knob::ramps)) o.ramps = static_cast<Ramps>(static_cast<int>(value(Knob::ramps)));
  if (is_turned(Knob::acceleration)) {
    turn(path.acceleration, path.deceleration, value(Knob::acceleration),
         diagonal(job->machine, &AxisLimits::acceleration));
  }
  if (is_turned(Knob::jerk)) {
    turn(path.jerk, path.jerk_deceleration, value(Knob::jerk), diagonal(job->machine, &AxisLimits::jerk));
  }
  if (is_turned(Knob::ramp_time)) {
    turn_time(o.t_acc, value(Knob::ramp_time));
    turn_time(o.t_dec, value(Knob::ramp_time));
  }
  if (is_turned(Knob::tolerance)) {
    double& size = o.corner.rule == CornerRule::junction ? o.corner.junction_deviation : o.corner.tolerance;
    size = std::max(1e-6, rounded_down(size * value(Knob::tolerance)));
  }
  if (is_turned(Knob::lookahead)) o.lookahead = static_cast<std::size_t>(value(Knob::lookahead));
  return job;
}

bool TuningSpace::is_dear(const Position& position) const {
  const auto job = job_at(position);
  return is_through_tube(*job) || may_leave_path(*job);
}

}  // namespace toolpace
