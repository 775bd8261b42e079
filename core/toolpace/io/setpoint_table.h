#pragma once
/// Setpoints as the columns that files show: edge units (mm, deg), names that carry them.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/kinematics/chain.h"
#include "toolpace/sample/setpoints.h"

namespace toolpace {

/// Time of row k [s]. Where the period is a whole number of nanoseconds, as every period that people type is, the
/// result is the double nearest to the exact decimal, so that files show 1.001 and not 1.0009999999999999.
class RowClock {
 public:
  explicit RowClock(double period);
  double time(std::uint64_t row) const;

 private:
  double period_;
  std::uint64_t nanoseconds_;  ///< 0 = the period is no whole number of them
};

/// Turns chunks of setpoints into columns, chunk by chunk; keeps nothing but the last rows that differences need.
class SetpointTable {
 public:
  /// @param axis_derivatives  adds v, a, j of each axis, as backward differences of the positions over one period: what
  ///                          the drives see. Before the first row the machine is taken to rest.
  /// @param tip_of  adds tip_x_mm, tip_y_mm, tip_z_mm: where the chain has the tip, in the workpiece; with the tool's length
  ///                of the setpoints, where they have one
  explicit SetpointTable(bool axis_derivatives, std::optional<Chain> tip_of = {})
      : axis_derivatives_(axis_derivatives), tip_of_(std::move(tip_of)) {}

  /// Makes `chunk` the present one; it must outlive the use of columns(). The first chunk decides the set of columns.
  /// Errors (input): columns of unequal length or other axes than before (code setpoint-columns), rows that do not
  /// follow on (setpoint-rows), values that are not finite in the units of the file
  /// (setpoint-not-finite).
  Result<void> load(const Setpoints& chunk);

  /// "t_s", "x_mm", …, without "line". Known after the first load().
  const std::vector<std::string>& names() const { return names_; }
  /// One pointer a name, each to rows() values.
  const std::vector<const double*>& columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  const std::uint32_t* lines() const { return lines_; }
  double period() const { return period_; }

 private:
  void decide_columns(const Setpoints& chunk);
  Result<void> check(const Setpoints& chunk) const;
  void fill(const Setpoints& chunk);
  void differentiate(std::size_t slot, const double* position);
  void find_tip(const Setpoints& chunk);

  bool axis_derivatives_;
  std::optional<Chain> tip_of_;
  bool started_ = false;
  double period_ = 0.0;
  std::uint64_t next_row_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::size_t> axes_;  ///< axes shown
  std::array<bool, kAxisCount> given_ = {};
  std::vector<std::string> names_;
  std::vector<const double*> columns_;
  const std::uint32_t* lines_ = nullptr;
  std::vector<double> time_;
  std::vector<std::vector<double>> rotary_;                      ///< scratch in degrees, one an axis shown
  std::array<std::vector<std::vector<double>>, 3> derivatives_;  ///< v, a, j: one an axis shown
  std::array<std::vector<double>, 3> tip_;
  std::vector<std::array<double, 3>> last_;  ///< position, v, a of the row before, one an axis shown
};

}  // namespace toolpace
