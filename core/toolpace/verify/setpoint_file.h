#pragma once
/// Reading setpoint files back, of every format that is written, in bounded memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/corner_rule.h"

namespace toolpace {

inline constexpr std::size_t kDerivatives = 3;  ///< of a position by time: speed, acceleration, jerk

/// What a file holds.
struct SetpointColumns {
  std::array<bool, kAxisCount> axis = {};
  bool time = false;
  bool profile = false;  ///< speed, acceleration, jerk along the path
  bool line = false;
  bool axis_derivatives = false;          ///< of any axis
  std::vector<std::string> ignored = {};  ///< names of columns that mean nothing here
};

/// What a file says of the plan that its setpoints are of.
struct SetpointOrigin {
  std::string law = {};                      ///< "quintic", …; empty = not told
  std::optional<CornerOptions> corner = {};  ///< of the job
  bool has_path_control = false;  ///< whether the program has path control of its own somewhere: G61, G64 P, …
  std::string shaper = {};        ///< that shaped them: "zv", …; empty = not told or none
};

/// Some consecutive rows, column by column; columns that the file lacks are empty.
struct SetpointRows {
  std::size_t first = 0;
  std::vector<double> time;                              ///< [s]
  std::array<std::vector<double>, kAxisCount> position;  ///< [mm, rad]
  std::vector<double> speed, acceleration, jerk;         ///< [mm/s, mm/s², mm/s³]
  std::vector<std::uint32_t> line;
  /// Where the path is about the tool's tip: as it tells the place of each row, and that of the row before [mm].
  std::array<std::vector<double>, 3> tip, tip_from;
  /// Speed, acceleration, jerk of each axis [mm or rad, s].
  std::array<std::array<std::vector<double>, kAxisCount>, kDerivatives> derivative;
  std::size_t count = 0;

  void clear();

  /// An axis as the path tells it [mm, rad].
  const std::vector<double>& told(std::size_t axis) const {
    return axis < 3 && !tip[0].empty() ? tip[axis] : position[axis];
  }
  /// By how much that changes from row i − 1 to row i; 0 without a column.
  double told_step(std::size_t axis, std::size_t i) const {
    if (axis < 3 && !tip[0].empty()) return tip[axis][i] - tip_from[axis][i];
    return position[axis].empty() ? 0.0 : position[axis][i] - position[axis][i - 1];
  }
};

/// An open setpoint file. Every fault of its text or structure is an error of kind input with file, line and column; what
/// cannot be read, or is changed meanwhile, is one of kind io.
class SetpointFile {
 public:
  virtual ~SetpointFile() = default;
  SetpointFile(const SetpointFile&) = delete;
  SetpointFile& operator=(const SetpointFile&) = delete;

  const SetpointColumns& columns() const { return columns_; }
  const SetpointOrigin& origin() const { return origin_; }

  /// Appends up to `limit` rows. @return how many; 0 = no more
  virtual Result<std::size_t> read(SetpointRows& rows, std::size_t limit) = 0;
  /// Begins again at the first row.
  virtual void rewind() = 0;
  /// How much has been read, 0 … 1.
  virtual double progress() const = 0;

 protected:
  SetpointFile() = default;
  SetpointColumns columns_;
  SetpointOrigin origin_;
};

}  // namespace toolpace
