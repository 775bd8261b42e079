#include "toolpace/pipeline/prove.h"

#include <algorithm>

#include "toolpace/io/setpoint_reader.h"
#include "toolpace/io/setpoint_table.h"
#include "toolpace/law/law_table.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/sample/shaper.h"

namespace toolpace {
namespace {

constexpr double kExact = 1e-6;  // [mm]

/// A plan's setpoints as if read from a file.
class SampledSetpoints final : public SetpointFile {
 public:
  explicit SampledSetpoints(const Outcome& outcome) : outcome_(outcome) {
    rewind();
    Setpoints first;
    sampler_->next(first, 1);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) columns_.axis[axis] = !first.position[axis].empty();
    columns_.time = columns_.profile = columns_.line = true;
    rewind();
  }

  Result<std::size_t> read(SetpointRows& rows, std::size_t limit) override {
    Setpoints chunk;
    sampler_->next(chunk, limit);
    const RowClock clock(chunk.period);
    for (std::size_t k = 0; k < chunk.size(); ++k) rows.time.push_back(clock.time(chunk.first_row + k));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) append(rows.position[axis], chunk.position[axis]);
    append(rows.speed, chunk.speed);
    append(rows.acceleration, chunk.acceleration);
    append(rows.jerk, chunk.jerk);
    append(rows.line, chunk.line);
    rows.count += chunk.size();
    read_ += chunk.size();
    return chunk.size();
  }

  void rewind() override {
    sampler_.emplace(sampler_of(outcome_));
    read_ = 0;
  }

  double progress() const override { return static_cast<double>(read_) / static_cast<double>(sampler_->rows()); }

 private:
  template <class T>
  static void append(std::vector<T>& column, const std::vector<T>& more) {
    column.insert(column.end(), more.begin(), more.end());
  }

  const Outcome& outcome_;
  std::optional<Sampler> sampler_;
  std::size_t read_ = 0;
};

Result<VerifyReport> judge(SetpointFile& file, const Outcome& outcome, bool measures, const Monitor& monitor) {
  const Job& job = *outcome.job;
  const Moves& moves = job.program->moves;
  const auto path = build_path(moves, job.machine.tool_change);  // as programmed: the outcome's may be smoothed
  if (!path) return tl::unexpected(path.error());
  const CornerOptions& corner = job.options.corner;
  ProgrammedPath program{*path, moves, judged_tolerance(moves, corner)};
  if (job.options.shaper == ShaperKind::none) {
    for (const std::uint32_t row : path->move) {
      program.segment_tolerance.push_back(corner_tolerance(moves, row, corner) + kExact);
    }
  } else {  // it rounds all corners, and curves: how far it may is what the job's tolerance says
    program.tolerance = std::max(*program.tolerance, corner.tolerance + kExact);
  }
  return verify(file, judged_machine(job.machine, outcome.ran), &program, {job.options.corner, measures, monitor});
}

}  // namespace

Machine judged_machine(const Machine& machine, const PlanOptions& options) {
  Machine judged = machine;
  if (law_row(options.law).bounds_jerk) return judged;
  judged.path.jerk = judged.path.jerk_deceleration = kUnlimited;
  for (auto& axis : judged.axes) axis.jerk = kUnlimited;
  return judged;
}

SetpointOrigin origin_of(const Outcome& outcome) {
  const Moves& moves = outcome.job->program->moves;
  const bool has_control = std::any_of(moves.mode.begin(), moves.mode.end(), [&](std::uint16_t mode) {
    return moves.modes[mode].control != PathControl::job_default;
  });
  const PlanOptions& options = outcome.job->options;
  const bool is_shaped = options.shaper != ShaperKind::none;
  return {std::string(law_row(outcome.ran.law).id), options.corner, has_control,
          is_shaped ? std::string(shaper_name(options.shaper)) : std::string()};
}

double corner_tolerance(const Moves& moves, std::uint32_t row, const CornerOptions& corner) {
  return tolerance_of(moves.modes[moves.mode[row]], rounding(corner));
}

double judged_tolerance(const Moves& moves, const CornerOptions& corner) {
  double tolerance = 0.0;
  for (std::uint32_t row = 0; row < moves.size(); ++row) {
    tolerance = std::max(tolerance, corner_tolerance(moves, row, corner));
  }
  return tolerance + kExact;
}

Result<VerifyReport> prove(const std::filesystem::path& setpoints, const Outcome& outcome, const Monitor& monitor) {
  auto file = open_setpoint_file(setpoints);
  if (!file) return tl::unexpected(file.error());
  auto report = judge(**file, outcome, true, monitor);
  const bool is_told = report || report.error().code != "setpoints-lines";
  return is_told ? std::move(report) : prove(outcome, monitor);
}

Result<VerifyReport> prove(const Outcome& outcome, const Monitor& monitor) {
  SampledSetpoints setpoints(outcome);
  return judge(setpoints, outcome, true, monitor);
}

Result<std::vector<Check>> broken_checks(const Outcome& outcome, const Monitor& monitor) {
  SampledSetpoints setpoints(outcome);
  auto report = judge(setpoints, outcome, false, monitor);
  if (!report) return tl::unexpected(report.error());
  std::erase_if(report->checks, [](const Check& c) { return !c.broken; });
  return std::move(report->checks);
}

bool is_proven(const Outcome& outcome, const Monitor& monitor) {
  const auto broken = broken_checks(outcome, monitor);
  return broken && broken->empty();
}

}  // namespace toolpace
