#pragma once
/// A whole program's runs, fitted.

#include <string_view>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/reading.h"
#include "toolpace/rewrite/write_run.h"

namespace toolpace::detail::rewrite {

/// Fits runs, and parts of them again.
class ProgramFitter {
 public:
  /// @param tolerance  [mm] > 0
  ProgramFitter(const ProgramLines& lines, const Reading& reading, double tolerance, bool has_arcs);

  /// An edit for each run; those that gain nothing have no stretches. @return errors: cancelled
  Result<std::vector<Edit>> fit(const Monitor& monitor);

  /// A run's rows as stretches that stay.
  static std::vector<Stretch> as_it_is(const Run& run);

  /// Fits a stretch with less: smooth → arcs → lines.
  void fit_simpler(const Edit& edit, Stretch& stretch);

 private:
  FitRules rules_for(const Run& run) const;

  const ProgramLines& lines_;
  const Reading& reading_;
  double tolerance_;
  bool has_arcs_;
  Curve curve_;
};

/// Puts all rows of a stretch back as they were.
void keep(Stretch& stretch, Stretch::Fit why);

/// Puts the rows of spans back as they were; nothing of them is left to drop where they were kept already.
/// @return whether anything changed
bool keep_span(Stretch& stretch, std::size_t span);

}  // namespace toolpace::detail::rewrite
