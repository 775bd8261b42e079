#include "toolpace/verify/verify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/limits/ceilings.h"
#include "toolpace/verify/corner_exemption.h"
#include "toolpace/verify/derivative_check.h"
#include "toolpace/verify/limit_check.h"
#include "toolpace/verify/path_check.h"
#include "toolpace/verify/profile_check.h"
#include "toolpace/verify/tangent_check.h"
#include "toolpace/verify/tip_rows.h"

namespace toolpace {
namespace {

constexpr double kFirstReach = kOnPath;  // [mm]
constexpr double kReachFactor = 8;
constexpr double kLastReach = 20;  // [mm] farther off, the file is of another program
constexpr double kNarrow = 1.01;   // its square: between a reach that is too short and one that is not
constexpr int kMostNarrowings = 12;

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

Error lines_missing() {
  return {ErrorKind::input,
          "setpoints-lines",
          "the program changes between axes and the tool's tip, and the file has no column line that tells where",
          "give a file with that column, such as .csv or .npy",
          {},
          {}};
}

/// Whether the steps of a corner would explain what is broken.
bool has_broken_steps(const VerifyReport& report) {
  return std::any_of(report.checks.begin(), report.checks.end(), [](const Check& c) {
    return c.broken && (c.kind == CheckKind::axis_acceleration || c.kind == CheckKind::axis_jerk ||
                        c.kind == CheckKind::path_acceleration || c.kind == CheckKind::path_deceleration ||
                        c.kind == CheckKind::path_jerk);
  });
}

/// The job's corner rule, as far as it is known. Without the program nothing tells where its own path control holds.
std::optional<CornerOptions> corner_rule(const SetpointFile& file, const VerifyOptions& options, bool has_program) {
  if (options.corner) return options.corner;
  const SetpointOrigin& origin = file.origin();
  return has_program || !origin.has_path_control ? origin.corner : std::nullopt;
}

/// Columns that are passed over.
std::string not_judged(const std::vector<std::string>& columns) {
  std::string names;
  for (const std::string& name : columns) names += (names.empty() ? "" : ", ") + (name.empty() ? "(no name)" : name);
  return "columns that are not judged: " + names;
}

/// Distances from the path within which setpoints are looked for, one after the other.
std::vector<double> reaches(const std::optional<double>& tolerance) {
  std::vector<double> all;
  for (double reach = kFirstReach; reach < kLastReach; reach *= kReachFactor) all.push_back(reach);
  if (tolerance && *tolerance > 0) all.push_back(*tolerance);
  std::sort(all.begin(), all.end());
  return all;
}

/// One file, judged in several passes.
class Judgement {
 public:
  Judgement(SetpointFile& file, const Machine& machine, double period, const ProgrammedPath* program,
            const VerifyOptions& options)
      : file_(file),
        machine_(machine),
        period_(period),
        program_(program),
        options_(options),
        corners_(machine, corner_rule(file, options, program != nullptr)) {}

  Result<VerifyReport> judge() {
    if (program_ == nullptr) return judge_limits();
    for (const double within : options_.measures ? std::vector{kFirstReach} : reaches(program_->tolerance)) {
      auto report = judge_where_followed(within);
      if (!report) return tl::unexpected(report.error());
      if (*report) return std::move(**report);
    }
    if (!options_.measures) return judge_within({});
    const auto reach = shortest_reach();
    if (!reach) return tl::unexpected(reach.error());
    return judge_within(*reach);
  }

 private:
  /// A distance within which the setpoints follow the path, and the longest one tried within which they do not.
  struct Reach {
    double within = 0.0, not_within = 0.0;
    double deviation = 0.0;  ///< of the setpoints, when looked for within it
    bool follows = false;
  };

  /// What a pass over the file keeps.
  struct Pass {
    VerifyReport report;
    bool followed = true;
  };

  PathCheck path_check(double reach) const { return {*program_, machine_, corners_, reach, period_}; }

  Result<VerifyReport> judge_limits() {
    auto pass = run_pass(nullptr);
    if (!pass) return tl::unexpected(pass.error());
    return std::move(pass->report);
  }

  /// Judges everything at once, as long as the setpoints follow the path; nothing where they do not.
  Result<std::optional<VerifyReport>> judge_where_followed(double within) {
    PathCheck path = path_check(within);
    auto pass = run_pass(&path);
    if (!pass) return tl::unexpected(pass.error());
    if (!pass->followed) {
      left_ = path.left();
      return std::nullopt;
    }
    if (left_) path.set_left(*left_);
    path.report(pass->report, true);
    return std::optional(std::move(pass->report));
  }

  Result<VerifyReport> judge_within(const Reach& reach) {
    if (reach.follows) {
      auto report = judge_where_followed(reach.within);
      if (!report) return tl::unexpected(report.error());
      if (*report) return std::move(**report);
    }
    auto report = judge_limits();  // they are judged all the same
    if (!report) return report;
    PathCheck path = path_check(kLastReach);
    if (left_) path.set_left(*left_);
    path.report(*report, false);
    return report;
  }

  /// Looks for the setpoints ever farther from the path until they follow it.
  Result<Reach> first_reach(const std::vector<double>& all) {
    Reach found;
    for (const double within : all) {
      const auto deviation = follow(within);
      if (!deviation) return tl::unexpected(deviation.error());
      found.within = within;
      found.follows = deviation->has_value();
      if (found.follows) {
        found.deviation = **deviation;
        return found;
      }
      found.not_within = within;
    }
    return found;
  }

  /// The shortest reach within which they follow it, to 2 %: looked for in the same way whether there is a tolerance or not.
  Result<Reach> shortest_reach() {
    auto found = first_reach(reaches({}));
    if (!found || !found->follows || found->not_within == 0) return found;
    bool was_shorter = true;
    for (int k = 0; k < kMostNarrowings && found->within > kNarrow * kNarrow * found->not_within; ++k) {
      const double middle = std::sqrt(found->within * found->not_within);
      const double next =
          was_shorter ? std::clamp(found->deviation, kNarrow * found->not_within, found->within / kNarrow) : middle;
      const auto deviation = follow(next);
      if (!deviation) return tl::unexpected(deviation.error());
      was_shorter = deviation->has_value();
      (was_shorter ? found->within : found->not_within) = next;
      if (was_shorter) found->deviation = **deviation;
    }
    return at_tolerance(*found);
  }

  /// A tolerance in the gap between what is within reach and what is not is decided by a search within it.
  Result<Reach> at_tolerance(Reach found) {
    const double tolerance = program_->tolerance.value_or(0);
    if (tolerance <= found.not_within || tolerance >= found.within) return found;
    const auto deviation = follow(tolerance);
    if (!deviation) return tl::unexpected(deviation.error());
    if (deviation->has_value()) found.within = tolerance;
    return found;
  }

  /// Deviation of the setpoints where they follow the path within a distance.
  Result<std::optional<double>> follow(double within) {
    file_.rewind();
    RowStream stream(file_);
    PathCheck path = path_check(within);
    for (;;) {
      const auto more = next(stream);
      if (!more) return tl::unexpected(more.error());
      if (!*more) break;
      if (!path.take(stream)) {
        left_ = path.left();
        return std::nullopt;
      }
    }
    if (path.has_followed()) return std::optional(path.deviation());
    left_ = path.left();
    return std::nullopt;
  }

  Result<bool> next(RowStream& stream) {
    const auto more = stream.next();
    if (!more) return more;
    if (options_.monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    options_.monitor.report(file_.progress());
    return more;
  }

  Result<Pass> run_pass(PathCheck* path) {
    file_.rewind();
    RowStream stream(file_);
    LimitCheck limits(machine_, period_, path != nullptr ? std::optional<double>(path->extent()) : std::nullopt);
    ProfileCheck profile(machine_, period_);
    TangentCheck tangent(period_);
    PathWorst along(machine_.path);
    DerivativeCheck derivatives(period_);
    CornerExemption exempt(corners_, period_);
    exempt.use(path != nullptr ? &path->corners() : nullptr);
    Pass pass;
    for (;;) {
      const auto more = next(stream);
      if (!more) return tl::unexpected(more.error());
      if (!*more) break;
      if (path != nullptr && !path->take(stream)) return Pass{{}, false};
      limits.take(stream, exempt);
      tangent.take(stream, limits.noise(), exempt, along);
      profile.take(stream, along);
      if (file_.columns().axis_derivatives) derivatives.take(stream);
    }
    if (path != nullptr) pass.followed = path->has_followed();
    pass.report.rows = stream.rows_read();
    pass.report.period = period_;
    limits.report(pass.report);
    along.report(pass.report);
    profile.report(pass.report);
    derivatives.report(pass.report);
    exempt.report(pass.report);
    return pass;
  }

  SetpointFile& file_;
  const Machine& machine_;
  double period_;
  const ProgrammedPath* program_;
  const VerifyOptions& options_;
  CornerLimit corners_;
  std::optional<Check> left_;  ///< where a narrower search had lost the path
};

}  // namespace

Result<VerifyReport> verify(SetpointFile& file, const Machine& machine, const ProgrammedPath* program,
                            const VerifyOptions& options) {
  const auto period = period_of(file, machine);
  if (!period) return tl::unexpected(period.error());
  if (program != nullptr) {
    if (auto fine = check_axes(file, *program); !fine) return tl::unexpected(fine.error());
  }
  const Machine judged = program != nullptr ? under(machine, highest_ceiling(program->moves)) : machine;
  std::optional<TipRows> about_tip;
  if (program != nullptr && !program->path.tellings.empty()) {
    about_tip.emplace(file, program->path, program->moves);
    if (!about_tip->can_tell()) return tl::unexpected(lines_missing());
  } else if (program == nullptr && options.tip_of) {
    about_tip.emplace(file, *options.tip_of);
  }
  SetpointFile& rows = about_tip ? *about_tip : file;
  auto report = Judgement(rows, judged, *period, program, options).judge();
  if (!report) return report;
  if (program != nullptr && program->moves.ceilings.size() > 1) {
    report->notes.push_back(
        "limits that the program sets are judged, too; where it changes them, the highest of each kind");
  }
  if (program == nullptr && has_broken_steps(*report)) {
    report->notes.push_back(
        "without the program corners are known and exempt between lines and even curves of a few rows alone: with it "
        "all are");
  }
  if (!corner_rule(file, options, program != nullptr) && has_broken_steps(*report)) {
    report->notes.push_back("the corner rule is not known: a reversal is exempt by what the servo rule lets pass");
  }
  if (!file.columns().ignored.empty()) report->notes.push_back(not_judged(file.columns().ignored));
  if (std::abs(*period - machine.period) > 1e-9 * machine.period) {
    report->notes.push_back("the file's period is " + std::to_string(*period * 1e3) + " ms, the machine's " +
                            std::to_string(machine.period * 1e3) + " ms");
  }
  return report;
}

}  // namespace toolpace
