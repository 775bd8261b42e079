#pragma once
/// The list of velocity laws. A new law is one header in this folder, one row in law_table.cpp and one line in
/// visit_law(); the command line, the workbench and the conformance tests follow from that.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "toolpace/law/five_phase_jerk.h"
#include "toolpace/law/five_phase_time.h"
#include "toolpace/law/law.h"
#include "toolpace/law/quintic.h"
#include "toolpace/law/seven_phase.h"
#include "toolpace/law/trapezoid.h"

namespace toolpace {

/// What a law's user has to set.
enum class LawParameter : std::uint8_t { time, acceleration, jerk };

struct LawRow {
  LawKind kind;
  std::string_view id;                       ///< as in --law and machine files
  std::string_view title;                    ///< for people, English
  bool needs_acceleration;                   ///< makes no sense without an acceleration limit
  bool needs_jerk;                           ///< makes no sense without a jerk limit
  bool uses_time;                            ///< reads RampLimits::time
  bool bounds_jerk;                          ///< keeps RampLimits::jerk
  std::span<const LawParameter> parameters;  ///< in the order in which a form shows them

  // The law's functions, for code that need not be fast. See VelocityLaw.
  double (*duration)(double dv, const RampLimits& limits);
  double (*reach)(double v, double length, const RampLimits& limits);
  double (*peak_acceleration)(double dv, const RampLimits& limits);
  double (*peak_jerk)(double dv, const RampLimits& limits);
  void (*append_ramp)(double v0, double v1, const RampLimits& limits, std::vector<Phase>& phases);
};

/// All laws, in the order in which a list shows them; row i has kind LawKind(i).
std::span<const LawRow> law_table();

const LawRow& law_row(LawKind kind);

/// @return the kind with this id, nothing where there is none
std::optional<LawKind> find_law(std::string_view id);

/// "trapezoid, five-phase-time, …", for messages.
std::string law_ids();

/// Calls f with an (empty) object of the law's type, so that f is compiled once for each law:
///   visit_law(kind, [&](auto law) { return Planner<decltype(law)>(…).run(); });
/// f must return the same type for all.
template <class F>
decltype(auto) visit_law(LawKind kind, F&& f) {
  switch (kind) {
    case LawKind::trapezoid: return std::forward<F>(f)(Trapezoid{});
    case LawKind::five_phase_time: return std::forward<F>(f)(FivePhaseTime{});
    case LawKind::five_phase_jerk: return std::forward<F>(f)(FivePhaseJerk{});
    case LawKind::seven_phase: return std::forward<F>(f)(SevenPhase{});
    case LawKind::quintic: break;
    case LawKind::time_optimal: return std::forward<F>(f)(TimeOptimal{});
  }
  return std::forward<F>(f)(Quintic{});
}

}  // namespace toolpace
