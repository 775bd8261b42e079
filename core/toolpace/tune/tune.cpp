#include "toolpace/tune/tune.h"

#include <algorithm>
#include <thread>

#include "toolpace/pipeline/many.h"
#include "toolpace/tune/search.h"
#include "toolpace/tune/trials.h"

namespace toolpace {
namespace {

constexpr std::size_t kBatch = 8;              // whatever the number of threads, so that results do not depend on it
constexpr std::size_t kMostStarted = 40;       // plans of the first design
constexpr std::size_t kLongProgram = 100'000;  // rows; plans of one hold much memory
constexpr double kTooFarOff = 1.2;             // times the error of a plan that is as fast: no more is looked at

std::size_t threads_for(const Job& job) {
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  return job.program->moves.size() > kLongProgram ? std::min(cores, kPlansAtOnce) : cores;
}

/// What was tried so far.
struct Log {
  std::vector<Tried> tried;
  std::vector<bool> is_bound;
  std::size_t plans = 0;

  /// What a plan may still show that is as slow as this. Of what is known now: not of plans that run beside it.
  WorthFollowing worth_following() const {
    return [known = tried](const Objectives& plan) {
      double least = kUnlimited;
      for (const Tried& t : known) {
        const bool beats = t.objectives.cycle_time <= plan.cycle_time &&
                           t.objectives.vibration.value_or(0.0) <= plan.vibration.value_or(0.0);
        if (beats) least = std::min(least, t.objectives.contour);
      }
      return least * kTooFarOff;
    };
  }
};

bool has_resonance(const ServoMachine& servo) { return !std::all_of(servo.begin(), servo.end(), is_stiff); }

struct Attempt {
  Result<Judged> made;
};

/// Tries a batch. Settings that cannot be planned are left out; the job as it is has to be.
Result<void> try_all(const TuningSpace& space, const std::vector<Position>& batch, Trials& trials, Log& log,
                     std::size_t threads, const Monitor& monitor) {
  const WorthFollowing worth = log.worth_following();
  const auto try_one = [&](std::size_t i, const Monitor& quiet) -> Result<Attempt> {
    return Attempt{trials.run(space.job_at(batch[i]), worth, quiet)};
  };
  auto attempts = for_many<Attempt>(batch.size(), threads, monitor, try_one);
  if (!attempts) return tl::unexpected(attempts.error());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Result<Judged>& trial = (*attempts)[i].made;
    if (!trial && (log.plans == 0 || trial.error().kind == ErrorKind::cancelled)) return tl::unexpected(trial.error());
    ++log.plans;
    if (!trial) continue;
    log.tried.push_back({batch[i], trial->objectives});
    log.is_bound.push_back(trial->is_bound);
  }
  return {};
}

TuneResult tuning_of(const TuningSpace& space, const Log& log, const TuneOptions& options) {
  TuneResult tuning;
  tuning.plans = log.plans;
  const auto tuned = [&](const Tried& t) { return Tuned{space.job_at(t.at), t.objectives}; };
  tuning.present = tuned(log.tried.front());
  const Objectives& present = tuning.present.objectives;
  tuning.limits.contour = options.contour.value_or(present.contour);
  if (present.vibration) tuning.limits.vibration = options.vibration.value_or(*present.vibration);
  std::vector<Tried> whole;
  std::vector<Objectives> objectives;
  for (std::size_t i = 0; i < log.tried.size(); ++i) {
    if (log.is_bound[i]) continue;
    whole.push_back(log.tried[i]);
    objectives.push_back(log.tried[i].objectives);
  }
  std::vector<Objectives> front;
  for (const std::size_t i : pareto_front(objectives)) {
    tuning.front.push_back(tuned(whole[i]));
    front.push_back(objectives[i]);
  }
  tuning.knee = knee_of(front);
  for (std::size_t i = 0; i < front.size() && !tuning.best; ++i) {
    if (tuning.limits.keeps(front[i])) tuning.best = i;
  }
  return tuning;
}

Monitor share_of(const Monitor& monitor, std::size_t done, std::size_t batch, std::size_t plans) {
  Monitor part{monitor.stop, {}};
  if (!monitor.progress) return part;
  part.progress = [&monitor, done, batch, plans](double fraction) {
    const double share =
        (static_cast<double>(done) + fraction * static_cast<double>(batch)) / static_cast<double>(plans);
    monitor.report(std::min(1.0, share));
  };
  return part;
}

}  // namespace

Error no_resonance_error() {
  return {
      ErrorKind::usage,
      "tune-no-resonance",
      "vibration is to be limited, but no axis of the machine has a resonance",
      "give resonance_hz of the axis that shakes in [servo.X] of the machine file; 'toolpace identify' finds it in a "
      "trace",
      {},
      {}};
}

Result<TuneResult> tune(const std::shared_ptr<const Job>& job, const TuneOptions& options, const Monitor& monitor) {
  const TuningSpace space(job, options.turned);
  const std::size_t threads = threads_for(*job);
  if (options.vibration && !has_resonance(job->machine.servo)) return tl::unexpected(no_resonance_error());
  Search search(space, options.contour, options.vibration);
  Trials trials;
  Log log;
  // The job alone first: what it shares with others is then there, and so is an error of it.
  std::vector<Position> design = search.first(std::clamp<std::size_t>(options.plans / 4, 1, kMostStarted));
  std::size_t started = 0;
  while (log.plans < options.plans) {
    if (log.plans > 0 && options.is_over && options.is_over()) break;
    const std::size_t room = options.plans - log.plans;
    std::vector<Position> batch;
    if (started < design.size()) {
      const std::size_t end = started == 0 ? 1 : std::min(design.size(), started + std::min(kBatch, room));
      batch.assign(design.begin() + static_cast<std::ptrdiff_t>(started),
                   design.begin() + static_cast<std::ptrdiff_t>(end));
      started = end;
    } else {
      batch = search.next(log.tried, std::min(kBatch, room));
    }
    if (batch.empty()) break;
    const Monitor part = share_of(monitor, log.plans, batch.size(), options.plans);
    if (auto done = try_all(space, batch, trials, log, threads, part); !done) return tl::unexpected(done.error());
  }
  return tuning_of(space, log, options);
}

Result<TuneResult> tune_by_list(const TuningSpace& space, const std::vector<Position>& list, const TuneOptions& options,
                                const Monitor& monitor) {
  Trials trials;
  Log log;
  std::vector<Position> all = {space.home()};
  all.insert(all.end(), list.begin(), list.end());
  const std::size_t threads = threads_for(*space.job_at(space.home()));
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = begin == 0 ? 1 : std::min(all.size(), begin + kBatch);
    const std::vector<Position> batch(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                      all.begin() + static_cast<std::ptrdiff_t>(end));
    const Monitor part = share_of(monitor, begin, batch.size(), all.size());
    if (auto done = try_all(space, batch, trials, log, threads, part); !done) return tl::unexpected(done.error());
    begin = end;
  }
  return tuning_of(space, log, options);
}

}  // namespace toolpace
