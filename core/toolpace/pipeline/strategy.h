#pragma once
/// The ways of making a motion from a job.

#include <memory>
#include <optional>
#include <string_view>

#include "toolpace/pipeline/job.h"
#include "toolpace/plan/smooth/plan_smooth.h"

namespace toolpace {

/// What a strategy plans from.
struct PlanTask {
  const Job& job;
  const Path& path;
  const Commands& commands;
  SpeedLimits& limits;  ///< of limit_speed(): curves at their top speeds. May be taken away
};

/// What comes of it.
struct Planned {
  SmoothPlan motion;
  SpeedLimits limits;     ///< that it was planned under
  PlanOptions ran = {};   ///< what of the job's options it really used, and what instead of others
  Settings ignored = {};  ///< what of the job's options changes nothing under it
};

/// A new way is one row of the table in strategy.cpp.
struct Strategy {
  std::string_view id;
  /// Does the motion leave the path, so that it is laid out as programmed? Otherwise with corner curves, where the job wants
  /// them.
  bool leaves_path;
  bool (*takes)(const Job& job, std::size_t segments);  ///< can it run this job?
  Result<Planned> (*plan)(const PlanTask& task, const Monitor& monitor);
};

/// The first row that takes a job, of those that leave the path or of those that do not.
const Strategy& strategy_of(const Job& job, std::size_t segments, bool leaves_path);
/// The first row of all.
const Strategy& strategy_of(const Job& job, std::size_t segments);

/// Whether a job whose corners are rounded may also be run through the tube: the faster motion is taken.
bool may_leave_path(const Job& job);

/// A job that stands for another one, with what of that one's settings it leaves out.
struct Candidate {
  std::shared_ptr<const Job> job;
  Settings ignored;
};

/// Another job whose motion, where it is faster and proven, serves as well: corners blended inside the same tolerance instead
/// of a motion through the tube. Nothing where there is none.
std::optional<Candidate> rival_of(const Job& job);

/// Of all strategies: settings that a motion has no use for, by the options that it ran with.
Settings unused_settings(const PlanOptions& ran, const Commands& commands);

/// Does the job look for a faster motion after it has a good one, through the tube or on its rounded path? Then a person who
/// waits is better served with quick_version() first: corners blended inside the same tolerance, and not timed anew.
bool takes_long(const Job& job);
std::shared_ptr<const Job> quick_version(const Job& job);

}  // namespace toolpace
