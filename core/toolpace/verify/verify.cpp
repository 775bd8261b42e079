#include "toolpace/verify/verify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/verify/derivative_check.h"
#include "toolpace/verify/limit_check.h"
#include "toolpace/verify/path_check.h"
#include "toolpace/verify/profile_check.h"

namespace toolpace {
namespace {

constexpr double kFirstReach = kOnPath;  // [mm]
constexpr double kReachFactor = 8;
constexpr double kLastReach = 20;  // [mm] farther off, the file is of another program

struct Pass {
  VerifyReport report;
  bool followed = true;
};

/// Period of the file: the first step of its time column; whole nanoseconds where it is that but for rounding.
Result<double> period_of(SetpointFile& file, const Machine& machine) {
  SetpointRows rows;
  const auto count = file.read(rows, 2);
  if (!count) return tl::unexpected(count.error());
  file.rewind();
  if (*count == 0)
    return tl::unexpected(Error{ErrorKind::input, "setpoints-empty", "there are no setpoints in the file", "", {}, {}});
  if (rows.time.size() < 2) return machine.period;
  const double step = rows.time[1] - rows.time[0];
  if (!(step > 0)) {
    return tl::unexpected(Error{ErrorKind::input, "setpoints-time", "the time does not go forward", "", {}, {}});
  }
  const double nanoseconds = std::round(step * 1e9);
  return nanoseconds >= 1 && std::abs(step * 1e9 - nanoseconds) < 1e-6 * nanoseconds ? nanoseconds / 1e9 : step;
}

Result<void> check_axes(const SetpointFile& file, const ProgrammedPath& program) {
  constexpr std::array<const char*, kAxisCount> kNames = {"x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const bool moves = std::any_of(program.path.node.begin(), program.path.node.end(),
                                   [&](const AxisVector& n) { return n[i] != program.path.node.front()[i]; });
    if (moves && !file.columns().axis[axis]) {
      return tl::unexpected(
          Error{ErrorKind::input,
                "setpoints-axes",
                std::string("the program moves an axis that the file has no column ") + kNames[axis] + " of",
                "is it the file of this program?",
                {},
                {}});
    }
  }
  return {};
}

/// Whether the steps of a corner would explain what is broken.
bool has_broken_steps(const VerifyReport& report) {
  return std::any_of(report.checks.begin(), report.checks.end(), [](const Check& c) {
    return c.broken && (c.kind == CheckKind::axis_acceleration || c.kind == CheckKind::axis_jerk);
  });
}

/// Columns that are passed over.
std::string not_judged(const std::vector<std::string>& columns) {
  std::string names;
  for (const std::string& name : columns) names += (names.empty() ? "" : ", ") + (name.empty() ? "(no name)" : name);
  return "columns that are not judged: " + names;
}

Result<Pass> run_pass(SetpointFile& file, const Machine& machine, double period, PathCheck* path,
                      const Monitor& monitor) {
  file.rewind();
  RowStream stream(file);
  LimitCheck limits(machine, period, path != nullptr ? std::optional<double>(path->extent()) : std::nullopt);
  ProfileCheck profile(machine, period);
  DerivativeCheck derivatives(period);
  const CornerLog none;
  Pass pass;
  for (;;) {
    const auto more = stream.next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    monitor.report(file.progress());
    if (path != nullptr && pass.followed) pass.followed = path->take(stream);
    if (path != nullptr && !pass.followed) return pass;
    limits.take(stream, path != nullptr ? path->corners() : none);
    profile.take(stream);
    if (file.columns().axis_derivatives) derivatives.take(stream);
  }
  if (path != nullptr) pass.followed = path->has_followed();
  pass.report.rows = stream.rows_read();
  pass.report.period = period;
  limits.report(pass.report);
  profile.report(pass.report);
  derivatives.report(pass.report);
  return pass;
}

std::vector<double> reaches(const std::optional<double>& tolerance) {
  std::vector<double> all;
  for (double reach = kFirstReach; reach < kLastReach; reach *= kReachFactor) all.push_back(reach);
  if (tolerance && *tolerance > 0) all.push_back(*tolerance);
  std::sort(all.begin(), all.end());
  return all;
}

/// Looks for the setpoints ever farther from the path until they follow it.
Result<VerifyReport> verify_on_path(SetpointFile& file, const Machine& machine, double period,
                                    const ProgrammedPath& program, const Monitor& monitor) {
  const auto all = reaches(program.tolerance);
  std::optional<Check> lost;
  for (const double reach : all) {
    PathCheck path(program, machine, reach, period);
    auto pass = run_pass(file, machine, period, &path, monitor);
    if (!pass) return tl::unexpected(pass.error());
    if (!pass->followed && reach < all.back()) {
      lost = path.left();
      continue;
    }
    if (pass->followed && lost) path.set_left(*lost);
    if (!pass->followed) {  // the limits are judged all the same
      auto limits = run_pass(file, machine, period, nullptr, monitor);
      if (!limits) return tl::unexpected(limits.error());
      pass = std::move(limits);
      pass->followed = false;
    }
    path.report(pass->report, pass->followed);
    return std::move(pass->report);
  }
  return VerifyReport{};
}

}  // namespace

Result<VerifyReport> verify(SetpointFile& file, const Machine& machine, const ProgrammedPath* program,
                            const Monitor& monitor) {
  const auto period = period_of(file, machine);
  if (!period) return tl::unexpected(period.error());
  Result<VerifyReport> report = VerifyReport{};
  if (program != nullptr) {
    if (auto fine = check_axes(file, *program); !fine) return tl::unexpected(fine.error());
    report = verify_on_path(file, machine, *period, *program, monitor);
  } else {
    auto pass = run_pass(file, machine, *period, nullptr, monitor);
    if (!pass) return tl::unexpected(pass.error());
    report = std::move(pass->report);
  }
  if (report && program == nullptr && has_broken_steps(*report)) {
    report->notes.push_back(
        "without the program only corners between straight lines are known and exempt: with it those of arcs are, too");
  }
  if (report && !file.columns().ignored.empty()) report->notes.push_back(not_judged(file.columns().ignored));
  if (report && std::abs(*period - machine.period) > 1e-9 * machine.period) {
    report->notes.push_back("the file's period is " + std::to_string(*period * 1e3) + " ms, the machine's " +
                            std::to_string(machine.period * 1e3) + " ms");
  }
  return report;
}

}  // namespace toolpace
