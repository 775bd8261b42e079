#include "toolpace/tune/trials.h"

#include <algorithm>

#include "toolpace/pipeline/follow.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/replan.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/pipeline/strategy.h"
#include "toolpace/servo/vibration.h"

namespace toolpace {
namespace {

/// Segments of all outcomes that are kept: a segment takes about a kilobyte with its limits and its plan.
constexpr std::size_t kMostSegments = 500'000;
constexpr std::size_t kMostKept = 6;
constexpr const char* kGivenUp = "tune-given-up";  // never leaves this file

/// Whether something of its outcome can be taken over.
bool stays_on_path(const Job& job) { return !is_through_tube(job) && !may_leave_path(job); }

}  // namespace

std::shared_ptr<const Outcome> Trials::nearest_to(const Job& job) {
  if (!stays_on_path(job)) return nullptr;
  const std::scoped_lock lock(shared_);
  const auto same_route = [&](const auto& o) { return has_same_route(job, *o->job); };
  const auto same_limits = [&](const auto& o) { return same_route(o) && has_same_limits(job, *o->job); };
  auto found = std::find_if(kept_.begin(), kept_.end(), same_limits);
  if (found == kept_.end()) found = std::find_if(kept_.begin(), kept_.end(), same_route);
  if (found == kept_.end()) return nullptr;
  std::rotate(kept_.begin(), found, found + 1);
  return kept_.front();
}

void Trials::keep(Outcome outcome) {
  if (!stays_on_path(*outcome.job)) return;
  auto kept = std::make_shared<const Outcome>(std::move(outcome));
  const std::scoped_lock lock(shared_);
  kept_.insert(kept_.begin(), std::move(kept));
  std::size_t segments = 0, count = 0;
  while (count < std::min(kept_.size(), kMostKept)) {
    segments += kept_[count]->path->size();
    if (count > 0 && segments > kMostSegments) break;
    ++count;
  }
  kept_.resize(count);
}

Result<Judged> Trials::run(std::shared_ptr<const Job> job, const WorthFollowing& worth, const Monitor& monitor) {
  const auto before = nearest_to(*job);
  auto outcome = before ? replan(std::move(job), *before, monitor) : toolpace::run(std::move(job), monitor);
  if (!outcome) return tl::unexpected(outcome.error());
  const auto shaken = vibration(*outcome->path, outcome->plan, outcome->node_time, outcome->job->machine.servo,
                                impulses_of(*outcome), {monitor.stop, {}});
  if (!shaken) return tl::unexpected(shaken.error());
  Objectives judged{setpoints_duration(*outcome), 0, largest_residual(*shaken)};
  const double most = worth ? worth(judged) : kUnlimited;
  double& worst = judged.contour;
  const auto watch = [&](const Setpoints&, const ServoTrace& trace, std::size_t rows) -> Result<void> {
    const auto begin = trace.contour_error.begin();
    worst = std::max(worst, *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(rows)));
    if (worst <= most) return {};
    return tl::unexpected(Error{ErrorKind::cancelled, kGivenUp, "", "", {}, {}});
  };
  const auto followed = follow(*outcome, watch, monitor);
  if (!followed && followed.error().code != kGivenUp) return tl::unexpected(followed.error());
  keep(std::move(*outcome));
  if (followed) worst = followed->max_contour_error;
  return Judged{judged, !followed};
}

}  // namespace toolpace
