#pragma once
/// Programs planned and written to a file, for tests that read the file back.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "temporary_directory.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/machine/setup.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/sample/sampler.h"
#include "toolpace/verify/verify.h"

namespace toolpace::testing {

/// Builds Moves row by row.
class Program {
 public:
  Program() { reading_.moves.files = {"test.ngc"}; }

  Program& start(double x, double y, double z = 0) {
    reading_.moves.start << x, y, z, 0, 0, 0;
    return *this;
  }
  Program& line(double x, double y, double z = 0, double feed = 100) {
    return add(MoveKind::feed, x, y, z, feed, kNoDetail);
  }
  Program& rotate(double a, double feed) {
    AxisVector end = here();
    end[3] = a;
    push(MoveKind::feed, end, feed, kNoDetail);
    return *this;
  }
  /// Arc or helix about a centre in the XY plane. @param sweep [rad], + counter-clockwise
  Program& arc(double cx, double cy, double sweep, double rise = 0, double feed = 100) {
    const AxisVector from = here();
    const Eigen::Vector3d centre(cx, cy, from[2]);
    const double c = std::cos(sweep), s = std::sin(sweep), dx = from[0] - cx, dy = from[1] - cy;
    reading_.moves.arcs.push_back({centre, Eigen::Vector3d::UnitZ(), sweep});
    const auto detail = static_cast<std::uint32_t>(reading_.moves.arcs.size() - 1);
    return add(MoveKind::arc, cx + c * dx - s * dy, cy + s * dx + c * dy, from[2] + rise, feed, detail);
  }
  /// Path mode of the moves that follow.
  Program& control(PathControl control) {
    reading_.moves.modes.push_back(reading_.moves.modes[0]);
    reading_.moves.modes.back().control = control;
    return *this;
  }
  Program& dwell(double seconds) {
    reading_.moves.dwells.push_back(seconds);
    push(MoveKind::dwell, here(), 0, static_cast<std::uint32_t>(reading_.moves.dwells.size() - 1));
    return *this;
  }

  std::shared_ptr<const Reading> reading() const { return std::make_shared<const Reading>(reading_); }
  const Moves& moves() const { return reading_.moves; }

 private:
  AxisVector here() const { return reading_.moves.empty() ? reading_.moves.start : reading_.moves.end.back(); }
  Program& add(MoveKind kind, double x, double y, double z, double feed, std::uint32_t detail) {
    AxisVector end = here();
    end.head<3>() << x, y, z;
    push(kind, end, feed, detail);
    return *this;
  }
  void push(MoveKind kind, const AxisVector& end, double feed, std::uint32_t detail) {
    Moves& m = reading_.moves;
    m.kind.push_back(kind);
    m.line.push_back(static_cast<std::uint32_t>(m.size()));
    m.file.push_back(0);
    m.mode.push_back(static_cast<std::uint16_t>(m.modes.size() - 1));
    m.detail.push_back(detail);
    m.end.push_back(end);
    m.feed.push_back(feed);
  }
  Reading reading_;
};

/// 100 mm/s, 2000 mm/s², 5e4 mm/s³ on each axis and along the path.
inline Setup axis_limited_setup() {
  Setup setup = default_setup();
  setup.machine.path = {100, 2000, 2000, 5e4, 5e4};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    setup.machine.axes[axis].speed = 100;
    setup.machine.axes[axis].acceleration = 2000;
    setup.machine.axes[axis].jerk = 5e4;
  }
  return setup;
}

/// Through the tolerance tube, seven-phase, under the limits of the axes.
inline std::shared_ptr<Job> smoothed_job(const Program& program) {
  auto job = std::make_shared<Job>();
  const Setup setup = axis_limited_setup();
  job->program = program.reading();
  job->machine = setup.machine;
  job->options = setup.options;
  job->options.law = LawKind::seven_phase;
  job->options.ramps = Ramps::span;
  job->options.corner.rule = CornerRule::smooth;
  return job;
}

inline Outcome planned(const Program& program, const Setup& setup) {
  auto job = std::make_shared<Job>();
  job->program = program.reading();
  job->machine = setup.machine;
  job->options = setup.options;
  auto outcome = run(job);
  EXPECT_TRUE(outcome) << outcome.error().message;
  return std::move(*outcome);
}

inline void write_setpoints(const Outcome& outcome, const std::filesystem::path& file,
                            const SetpointFileOptions& options = {}) {
  auto writer = open_setpoint_writer(file, options);
  ASSERT_TRUE(writer) << writer.error().message;
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, outcome.job->machine.period);
  for (Setpoints chunk; sampler.next(chunk);) ASSERT_TRUE((*writer)->write(chunk));
  ASSERT_TRUE((*writer)->finish());
}

inline VerifyReport verified(const std::filesystem::path& file, const Machine& machine, const Moves* moves = nullptr,
                             std::optional<double> tolerance = {}) {
  auto setpoints = open_setpoint_file(file);
  EXPECT_TRUE(setpoints) << setpoints.error().message;
  if (moves == nullptr) return verify(**setpoints, machine).value();
  const Path path = build_path(*moves, machine.tool_change).value();
  const ProgrammedPath program{path, *moves, tolerance};
  auto report = verify(**setpoints, machine, &program);
  EXPECT_TRUE(report) << report.error().message;
  return report.value();
}

/// What is broken, as text for failure messages.
inline std::string broken(const VerifyReport& report) {
  std::string text;
  for (const auto& c : report.checks) {
    if (!c.broken) continue;
    text += std::string(key_of(c.kind)) + (c.axis ? std::string(" ") + kAxisNames[*c.axis] : "") + " " +
            std::to_string(c.value) + " limit " + std::to_string(c.limit) + " bound " + std::to_string(c.bound) +
            " row " + std::to_string(c.row) + "\n";
  }
  return text;
}

inline const Check& check_of(const VerifyReport& report, CheckKind kind, std::optional<std::size_t> axis = {}) {
  for (const auto& c : report.checks) {
    if (c.kind == kind && c.axis == axis) return c;
  }
  throw std::logic_error(std::string("no such check: ") + key_of(kind));
}

}  // namespace toolpace::testing
