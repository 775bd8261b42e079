#pragma once
/// Setpoints against the programmed path: distance, order, corners, lines, end.

#include <cstdint>
#include <optional>
#include <utility>

#include "toolpace/limits/machine.h"
#include "toolpace/verify/corner_limit.h"
#include "toolpace/verify/corner_log.h"
#include "toolpace/verify/path_follower.h"
#include "toolpace/verify/path_vertices.h"
#include "toolpace/verify/programmed_path.h"
#include "toolpace/verify/report.h"
#include "toolpace/verify/row_stream.h"
#include "toolpace/verify/slack_rule.h"
#include "toolpace/verify/worst.h"

namespace toolpace {

/// Follows the path with the setpoints within `reach` of it and, while it does:
/// - measures the distance of each setpoint to the exact curve that it is matched to;
/// - measures how far the path is from the straight lines between setpoints (chord error);
/// - measures, where the path is about the tool's tip, the angle between the tool and the programmed one;
/// - logs each node that is passed on the path, as each next to G61 or G61.1 is, with a step of direction or curvature:
///   V·|Δu| and V²·|Δκ| of each axis, V at most what the corner rule lets pass where both sides are exact, elsewhere at a turn
///   back what one would. On a side where corners may be smoothed the motion arrives or leaves as its setpoints say, which may
///   be another direction than that of the block;
/// - compares the line column with the lines of the path under the setpoint.
/// Setpoints that cut a corner, as smoothing does, are off the path there and get no such exemption.
class PathCheck {
 public:
  /// @param corners  up to which speed corners are exempt
  /// @param reach    [mm] how far setpoints are looked for beside the path
  /// @param period   [s]
  PathCheck(const ProgrammedPath& program, const Machine& machine, const CornerLimit& corners, double reach,
            double period);

  /// Goes through the rows up to two beyond the window's end. @return false once the setpoints have left the path
  bool take(const RowStream& stream);
  const CornerLog& corners() const { return corners_; }
  /// Largest coordinate, or centre + radius, of the path [mm].
  double extent() const;

  /// After the last row. Also false if the path has not been followed to its end.
  bool has_followed();
  void report(VerifyReport& report, bool followed) const;
  /// Largest distance of a setpoint so far [mm].
  double deviation() const { return deviation_.check().value; }
  /// Where the setpoints left the path.
  const Check& left() const { return left_; }
  /// Shows the place where a narrower search had lost the path.
  void set_left(const Check& left) { left_ = left; }

 private:
  /// Whether a node may have been passed in the row interval before or after the one that the matches say.
  struct Doubt {
    bool earlier, later;
  };
  bool take_row(const RowStream& stream, std::size_t local);
  void take_crossings(const RowStream& stream, std::size_t local, const AxisVector& to, const PathMatch& before,
                      bool on_path);
  void log_detour(const RowStream& stream, std::size_t local, const AxisVector& to,
                  std::pair<std::size_t, std::size_t> crossed);
  bool is_passed_exactly(std::size_t left) const;
  /// A node, and by how much each axis' curvature changes there.
  struct Joint {
    std::size_t left;
    AxisVector bend;                     ///< [1/mm, rad/mm²]
    std::optional<AxisVector> tip_turn;  ///< change of the tip's direction; none where the path is the axes'
  };
  std::optional<CornerOptions> rule_behind(std::size_t left) const;
  CornerEvent step_at(const CornerRun& run, const Joint& joint) const;
  bool lies_on_line(std::size_t segment, const AxisVector& point) const;
  void log_corner(const RowStream& stream, std::size_t local, const PathVertex& node, Doubt doubt);
  void take_line(const RowStream& stream, std::size_t local);
  Frame axes_at_node(std::size_t segment, double s) const;
  void take_tool(const RowStream& stream, std::size_t local);
  Eigen::Vector3d programmed_tool(const Chain& chain, const PathVertex& end, const Eigen::Vector3d& run);
  double exact_distance(const AxisVector& point);
  double chord_error(std::size_t cell, double low, double high, const AxisVector& to);

  const Path& path_;
  const Moves& moves_;
  double period_;
  double reach_;
  double sagitta_;
  bool rotary_;
  CornerLimit corner_limit_;
  SlackRule slack_;
  std::optional<double> tolerance_;
  PathVertices vertices_;
  PathFollower follower_;
  CornerLog corners_;
  AxisVector last_ = AxisVector::Zero();  ///< weighted point of the row before
  double last_distance_ = 0.0;            ///< [mm] of it to the path
  std::int64_t next_row_ = 0;
  Worst deviation_, chord_, tool_;
  Check end_;
  Check left_;
  std::int64_t line_mismatches_ = 0;
  Check line_;
};

}  // namespace toolpace
