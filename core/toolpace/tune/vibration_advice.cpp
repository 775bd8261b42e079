#include "toolpace/tune/vibration_advice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>

#include "toolpace/pipeline/many.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/servo/axis_modes.h"
#include "toolpace/servo/vibration.h"
#include "toolpace/tune/tune.h"

namespace toolpace {
namespace {

constexpr std::size_t kLooks = 600;    // over all times
constexpr double kLongest = 6.5;       // periods of the slowest mode
constexpr std::size_t kMostTimes = 7;  // that are planned
constexpr int kGoldenRounds = 80;
constexpr double kCloseBy = 1e-10;  // relative: of a time

/// What one ramp leaves on an axis; the acceleration is of the size of a ramp to speed 1.
double left_by(CalmBy by, const ServoAxis& servo, double time) {
  AxisModes modes(servo);
  if (by == CalmBy::five_phase) {  // a triangle
    modes.run({0, 4 / (time * time)}, time / 2);
    modes.run({2 / time, -4 / (time * time)}, time / 2);
    return modes.amplitude();
  }
  if (by == CalmBy::quintic) {  // 30u²(1 − u)²/T
    const double t3 = std::pow(time, 3);
    modes.run({0, 0, 30 / t3, -60 / (t3 * time), 30 / (t3 * time * time)}, time);
    return modes.amplitude();
  }
  // The acceleration rises to 1 and stays: what is left is the vibration about where it then holds the slide.
  double sum = 0;
  for (const AxisMode& m : modes_of(servo)) {
    Mode mode(m.frequency, m.damping);
    mode.run({0, 1 / time}, time);
    mode.set({mode.displacement() + 1 / (mode.omega() * mode.omega()), mode.speed()});
    sum += m.share * mode.amplitude() * mode.omega();
  }
  return sum;
}

double left_by_all(CalmBy by, const ServoMachine& servo, double time) {
  double most = 0;
  for (const ServoAxis& axis : servo) {
    if (!is_stiff(axis)) most = std::max(most, left_by(by, axis, time));
  }
  return most;
}

/// Between two times, one of them in the middle smaller than both.
double smallest_between(const std::function<double(double)>& value, double low, double high) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = value(a), at_b = value(b);
  for (int i = 0; i < kGoldenRounds && high - low > kCloseBy * high; ++i) {
    if (at_a <= at_b) {
      high = b, b = a, at_b = at_a;
      a = high - golden * (high - low), at_a = value(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + golden * (high - low), at_b = value(b);
    }
  }
  return (low + high) / 2;
}

std::shared_ptr<Job> with(const Job& job, LawKind law) {
  auto changed = std::make_shared<Job>(job);
  changed->options.law = law;
  return changed;
}

using Candidates = std::vector<CalmChoice>;

void add_five_phase(const Job& job, Candidates& list) {
  for (const double time : calm_times(CalmBy::five_phase, job.machine.servo, 1e-3)) {
    auto changed = with(job, LawKind::five_phase_time);
    changed->options.t_acc = changed->options.t_dec = time;
    list.push_back({CalmBy::five_phase, std::move(changed)});
  }
}

/// @param jerk  of a ramp of a time
void add_jerks(CalmBy by, LawKind law, const Job& job, double least, const std::function<double(double)>& jerk,
               Candidates& list) {
  for (const double time : calm_times(by, job.machine.servo, least)) {
    auto changed = with(job, law);
    PathLimits& path = changed->machine.path;
    path.jerk = std::min(path.jerk, jerk(time));
    path.jerk_deceleration = std::min(path.jerk_deceleration, jerk(time));
    list.push_back({by, std::move(changed)});
  }
}

/// All that is tried.
Candidates candidates_for(const Job& job, const Summary& summary) {
  Candidates list;
  add_five_phase(job, list);
  const PathLimits& path = job.machine.path;
  const double acceleration = is_finite(path.acceleration) ? path.acceleration : summary.peaks.acceleration;
  const double most_jerk = std::max(path.jerk, 1.0), speed = summary.peaks.speed;
  if (acceleration > 0) {
    add_jerks(
        CalmBy::seven_phase, LawKind::seven_phase, job, is_finite(most_jerk) ? acceleration / most_jerk : 1e-4,
        [=](double time) { return acceleration / time; }, list);
  }
  if (speed > 0) {  // the largest jerk of a ramp to a speed in a time: 10·v/(√3·T²)
    const double least = is_finite(most_jerk) ? std::sqrt(10 * speed / (std::sqrt(3.0) * most_jerk)) : 1e-4;
    add_jerks(
        CalmBy::quintic, LawKind::quintic, job, least,
        [=](double time) { return 10 * speed / (std::sqrt(3.0) * time * time); }, list);
  }
  for (const ShaperKind kind : kShaperKinds) {
    if (kind == ShaperKind::none) continue;
    auto changed = std::make_shared<Job>(job);
    changed->options.shaper = kind;
    list.push_back({CalmBy::shaper, std::move(changed)});
  }
  return list;
}

Result<CalmChoice> measured(CalmChoice choice, const Outcome& outcome, const Monitor& monitor) {
  const auto shaken = vibration(*outcome.path, outcome.plan, outcome.node_time, outcome.job->machine.servo,
                                impulses_of(outcome), monitor);
  if (!shaken) return tl::unexpected(shaken.error());
  choice.job = outcome.job;
  choice.cycle_time = setpoints_duration(outcome);
  choice.residual = largest_residual(*shaken).value_or(0.0);
  return choice;
}

/// Whether one is the better pick.
bool is_better(const CalmChoice& a, const CalmChoice& b, const std::optional<double>& limit) {
  const bool keeps_a = limit && a.residual <= *limit, keeps_b = limit && b.residual <= *limit;
  if (keeps_a != keeps_b) return keeps_a;
  return keeps_a ? a.cycle_time < b.cycle_time : a.residual < b.residual;
}

bool is_same_kind(const CalmChoice& a, const CalmChoice& b) {
  return a.by == b.by && (a.by != CalmBy::shaper || a.job->options.shaper == b.job->options.shaper);
}

void settle(VibrationAdvice& advice, const Candidates& tried, const std::optional<double>& limit) {
  for (const CalmChoice& choice : tried) {
    const auto same = std::find_if(advice.choices.begin(), advice.choices.end(),
                                   [&](const CalmChoice& c) { return is_same_kind(c, choice); });
    if (same == advice.choices.end()) {
      advice.choices.push_back(choice);
    } else if (is_better(choice, *same, limit)) {
      *same = choice;
    }
  }
  std::stable_sort(advice.choices.begin(), advice.choices.end(),
                   [](const CalmChoice& a, const CalmChoice& b) { return a.cycle_time < b.cycle_time; });
  CalmChoice best = advice.present;
  for (std::size_t i = 0; i < advice.choices.size(); ++i) {
    const CalmChoice& choice = advice.choices[i];
    if ((limit && choice.residual > *limit) || !is_better(choice, best, limit)) continue;
    best = choice;
    advice.best = i;
  }
}

}  // namespace

std::vector<double> calm_times(CalmBy by, const std::array<ServoAxis, kAxisCount>& servo, double least) {
  double slowest = kUnlimited, fastest = 0;
  for (const ServoAxis& axis : servo) {
    for (const AxisMode& m : modes_of(axis)) {
      slowest = std::min(slowest, m.frequency);
      fastest = std::max(fastest, m.frequency);
    }
  }
  std::vector<double> times;
  if (fastest == 0) return times;
  const double first = std::max(least, 0.5 / fastest), last = kLongest / slowest;
  const auto at = [&](std::size_t i) {
    return first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(kLooks));
  };
  const auto value = [&](double time) { return left_by_all(by, servo, time); };
  if (!(last > first)) return times;
  double before = value(at(0)), here = value(at(1));
  for (std::size_t i = 2; i <= kLooks && times.size() < kMostTimes; ++i) {
    const double next = value(at(i));
    if (here < before && here <= next) times.push_back(smallest_between(value, at(i - 2), at(i)));
    before = here, here = next;
  }
  return times;
}

Result<VibrationAdvice> advise_on_vibration(const std::shared_ptr<const Job>& job, std::optional<double> limit,
                                            const Monitor& monitor) {
  if (std::all_of(job->machine.servo.begin(), job->machine.servo.end(), is_stiff))
    return tl::unexpected(no_resonance_error());
  const auto outcome = run(job, {monitor.stop, {}});
  if (!outcome) return tl::unexpected(outcome.error());
  auto present = measured({CalmBy::nothing, job}, *outcome, {monitor.stop, {}});
  if (!present) return tl::unexpected(present.error());
  const Candidates list = candidates_for(*job, outcome->summary);
  const auto try_one = [&](std::size_t i, const Monitor& quiet) -> Result<std::optional<CalmChoice>> {
    const auto planned = run(list[i].job, quiet);
    if (!planned && planned.error().kind == ErrorKind::cancelled) return tl::unexpected(planned.error());
    if (!planned) return std::nullopt;
    auto choice = measured(list[i], *planned, quiet);
    if (!choice) return tl::unexpected(choice.error());
    return std::optional(*std::move(choice));
  };
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const auto tried = for_many<std::optional<CalmChoice>>(list.size(), cores, monitor, try_one);
  if (!tried) return tl::unexpected(tried.error());
  Candidates made;
  for (const auto& choice : *tried) {
    if (choice) made.push_back(*choice);
  }
  VibrationAdvice advice;
  advice.present = *std::move(present);
  settle(advice, made, limit);
  return advice;
}

}  // namespace toolpace
