#include "toolpace/tune/single_changes.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/many.h"
#include "toolpace/tune/trials.h"
#include "toolpace/tune/tuning_space.h"

namespace toolpace {
namespace {

constexpr double kMostOverride = 2;  // of the feed

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

std::shared_ptr<Job> with_setup(const Job& job, const Setup& setup) {
  auto changed = std::make_shared<Job>(job);
  changed->machine = setup.machine;
  changed->options = setup.options;
  return changed;
}

using Jobs = std::vector<std::shared_ptr<const Job>>;

void add_numbers(const Job& job, double factor, Jobs& jobs) {
  Setup setup{job.machine, job.options};
  for (const SetupSection& section : setup_sections(setup)) {
    for (const NumberKey& key : section.numbers) {
      if (!is_limit(key, job.options)) continue;
      const double before = *key.value;
      for (const double tried : {before * factor, before / factor}) {
        if (!is_in_range(tried / key.unit, key.range)) continue;
        *key.value = tried;
        jobs.push_back(with_setup(job, setup));
      }
      *key.value = before;
    }
  }
  const double feed = setup.options.feed_override;
  for (const double tried : {feed * factor, feed / factor}) {
    if (tried > kMostOverride) continue;
    setup.options.feed_override = tried;
    jobs.push_back(with_setup(job, setup));
  }
}

void add_choices(const std::shared_ptr<const Job>& job, Jobs& jobs) {
  for (const Knob knob : {Knob::law, Knob::corner, Knob::ramps}) {
    const TuningSpace space(job, std::span(&knob, 1));
    for (std::size_t place = 0; place < space.places(knob); ++place) {
      Position position = space.home();
      position[static_cast<std::size_t>(knob)] = static_cast<std::uint16_t>(place);
      if (space.canonical(position) != space.home()) jobs.push_back(space.job_at(position));
    }
  }
}

void add_depths(const Job& job, Jobs& jobs) {
  const auto& own = job.options.lookahead;
  if (!own || sees_all(job)) return;
  const auto add = [&](std::optional<std::size_t> depth) {
    auto changed = std::make_shared<Job>(job);
    changed->options.lookahead = depth;
    jobs.push_back(std::move(changed));
  };
  if (*own > 1) add(*own / 2);
  if (*own < kDeepestLookahead / 2) add(*own * 2);
  add(std::nullopt);
}

/// Of one that may have failed for reasons of its own.
struct Tryout {
  Result<Judged> made;
};

}  // namespace

Result<SingleChanges> try_single_changes(const std::shared_ptr<const Job>& job, double factor, const Monitor& monitor) {
  Jobs jobs = {job};
  add_numbers(*job, factor, jobs);
  add_choices(job, jobs);
  add_depths(*job, jobs);
  Trials trials;
  const auto try_one = [&](std::size_t i, const Monitor& quiet) -> Result<Tryout> {
    return Tryout{trials.run(jobs[i], {}, quiet)};
  };
  const auto attempts = for_many<Tryout>(jobs.size(), kPlansAtOnce, monitor, try_one);
  if (!attempts) return tl::unexpected(attempts.error());
  const Result<Judged>& present = attempts->front().made;
  if (!present) return tl::unexpected(present.error());
  SingleChanges found{present->objectives, {}};
  for (std::size_t i = 1; i < jobs.size(); ++i) {
    const Result<Judged>& made = (*attempts)[i].made;
    if (!made) continue;
    found.changes.push_back({jobs[i], found.present.cycle_time - made->objectives.cycle_time,
                             made->objectives.contour - found.present.contour});
  }
  std::stable_sort(found.changes.begin(), found.changes.end(),
                   [](const SingleChange& a, const SingleChange& b) { return a.saved > b.saved; });
  return found;
}

}  // namespace toolpace
