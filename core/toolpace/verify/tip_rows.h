#pragma once
/// A setpoint file whose rows tell, besides the axes, where the tip is in the workpiece.

#include <unordered_set>

#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"
#include "toolpace/verify/setpoint_file.h"

namespace toolpace {

/// Adds SetpointRows::tip, as the path tells the place of each row, and tip_from. Which of the path's chains a row is told by, its
/// NC line says.
class TipRows final : public SetpointFile {
 public:
  /// @pre path.tellings is not empty. Keeps a reference to the file
  TipRows(SetpointFile& file, const Path& path, const Moves& moves);
  /// All rows about the tip of one chain.
  TipRows(SetpointFile& file, const Chain& chain);

  /// Whether the file tells enough for that: the lines, where there is more than one chain.
  bool can_tell() const { return columns_.line || stretches_.size() == 1; }

  Result<std::size_t> read(SetpointRows& rows, std::size_t limit) override;
  void rewind() override;
  double progress() const override { return file_.progress(); }

 private:
  void add_row(SetpointRows& rows, std::size_t row);
  Eigen::Vector3d from_before(const Eigen::Vector3d& tip) const;

  SetpointFile& file_;
  /// Rows that are told alike.
  struct Stretch {
    Chain chain;
    std::unordered_set<std::uint32_t> lines;     ///< of their moves
    AxisVector first_axes = AxisVector::Zero();  ///< where the machine rests at their beginning
  };
  std::vector<Stretch> stretches_;
  std::size_t stretch_ = 0;  ///< of the row before
  bool started_ = false;
  AxisVector last_axes_ = AxisVector::Zero();
  Eigen::Vector3d last_tip_ = Eigen::Vector3d::Zero();
};

}  // namespace toolpace
