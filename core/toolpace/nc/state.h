#pragma once
/// All that a controller remembers between blocks while it interprets a program. Lengths in mm, angles in degrees.

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/kinematics/inverse.h"
#include "toolpace/nc/motion/offset_geometry.h"
#include "toolpace/nc/moves.h"
#include "toolpace/nc/text/words.h"

namespace toolpace::nc {

inline constexpr double kMmPerInch = 25.4;

/// One value an axis: X Y Z in mm, A B C in degrees.
using Position = std::array<double, kAxisCount>;

/// Plane of arcs: indices of its first and second axis and of the axis normal to it (right-handed).
struct PlaneAxes {
  std::size_t first, second, normal;
};
constexpr PlaneAxes plane_axes(Code plane) {
  if (plane == 180) return {2, 0, 1};
  if (plane == 190) return {1, 2, 0};
  return {0, 1, 2};
}

/// Modal state: what M70 saves and the workbench shows.
struct Modal {
  Code motion = 800;  ///< G80: none
  Code plane = 170;
  Code units = 210;
  Code distance = 900;
  Code arc_distance = 911;
  Code feed_mode = 940;
  Code compensation = 400;
  Code tool_length = 490;
  Code retract = 990;
  Code path_control = 640;
  Code spindle_mode = 970;
  Code lathe_diameter = 80;
  int system = 1;                ///< 1 … 9: G54 … G59.3
  double path_tolerance = 0.0;   ///< [mm] of G64 P
  double naive_tolerance = 0.0;  ///< [mm] of G64 Q
  bool tolerance_given = false;  ///< G64 came with P
  double feed = 0.0;             ///< as programmed: units a minute, a turn or 1/min; 0 = none
  double feed_linear = 0.0;      ///< the same with lengths in mm, fixed when F was read
  double spindle_speed = 0.0;    ///< [rev/min]; under G96 m/min, in inch programs ft/min
  double spindle_limit = std::numeric_limits<double>::infinity();  ///< [rev/min] D of G96
  int spindle_direction = 0;                                       ///< −1, 0, +1 (clockwise)
  bool polar = false;  ///< G16: X is a radius, Y an angle, or what the plane has for them
  bool mist = false, flood = false;
  bool holds_overrides = false;  ///< M49, M50 P0: those of feed and rapid do not count
  bool operator==(const Modal&) const = default;

  double unit() const { return units == 200 ? kMmPerInch : 1.0; }
  bool incremental() const { return distance == 910; }
};

/// What a spindle besides the first is told: blocks with $ exchange it with the first one's while they run.
struct OtherSpindle {
  Code mode = 970;
  double speed = 0.0;
  double limit = std::numeric_limits<double>::infinity();
  int direction = 0;
};

/// One factor an axis about a fixed point: scaled = factor·value + offset. Below 0 it mirrors.
struct Scaling {
  Position factor{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  Position offset{};
};

/// Where work coordinates lie in the machine: machine = R(rotation)·(scaled(work) + shift) + origin + tool_length.
struct Offsets {
  Position origin{};      ///< of the active system
  double rotation = 0.0;  ///< [deg] of the active system, about Z
  Position shift{};       ///< G92 and G52, while they apply
  Position tool_length{};
  bool is_scaled = false;
  Scaling scaling;  ///< G51 and G51.1, while they apply
};

struct Tool {
  int number = 0;
  int pocket = 0;
  Position offset{};
  double diameter = 0.0;
  double front_angle = 0.0, back_angle = 0.0;
  int orientation = 0;
};

/// Sticky words of canned cycles.
struct CycleMemory {
  Code code = kNoCode;  ///< words stick only while the same cycle goes on
  double r = 0.0, bottom = 0.0, dwell = 0.0, peck = 0.0, i = 0.0, j = 0.0, k = 0.0;
  bool has_r = false, has_bottom = false;
  bool bottom_is_increment = false;     ///< W of lathes: it counts from R
  std::optional<double> initial_level;  ///< level before the first cycle of a series, in the plane's normal axis
};

/// Sticky words of G90, G92 and G94 of lathes.
struct TurningMemory {
  Code code = kNoCode;
  Position end{};
  std::array<bool, kAxisCount> given{};
  double taper = 0.0;  ///< [mm] R: where the cut begins, seen from where it ends
  double lead = 0.0;   ///< [mm] E of threads; 0 = F
};

/// What the first blocks of G71 to G76 of lathes say for the second ones. Lengths in mm, across radii.
struct TurningSetup {
  double step = 1.0;     ///< depth of a pass of G71 and G72
  double retract = 0.5;  ///< of G71, G72, G74 and G75
  double relief_x = 0.0, relief_z = 0.0;
  int repeats = 1;  ///< of G73
  int finishing_passes = 1;
  double flank_angle = 0.0;  ///< [rad] half the angle of a thread, which it is cut in along
  double least_cut = 0.0, last_cut = 0.0;
  double pull_out = 0.0;  ///< [leads] over which a thread leaves the work at 45 degrees
};

/// Cutter radius compensation in progress.
struct Compensation {
  struct Origin {
    double x = 0.0, z = 0.0;
  };
  double radius = 0.0;  ///< [mm] > 0 while active
  Origin origin;        ///< [mm] from the centre of a lathe tool's nose to its controlled point
  bool first_move_pending = false;
  bool arc_forbidden = false;  ///< the move after G40 must be straight
  Position programmed{};       ///< end of the contour as programmed (work coordinates); position holds the tool's
  // The last compensated row, which a following inside corner still may shorten.
  bool has_open = false;
  bool open_is_entry = false;           ///< the entry may end anywhere on its line, as in LinuxCNC
  bool open_is_reversed = false;        ///< the corner before it has cut off more of it than there is
  bool next_is_reversed = false;        ///< the same of the row to come
  std::optional<std::size_t> open_row;  ///< none while nothing is written
  OffsetElement open;
};

/// Spline in progress.
struct SplineMemory {
  std::array<double, 2> last_handle{};  ///< end minus second control point of the last G5, mirrored by the next
  bool after_cubic = false;
  // G5.2 … G5.3
  bool collecting = false;
  int order = 3;
  std::optional<double> inverse_feed;         ///< [1/min] F of any of its blocks under G93
  std::vector<std::array<double, 3>> points;  ///< x, y, weight
};

/// A move with ,C or ,R: it waits for the next one, with which it makes the corner.
struct WaitingMove {
  Block block;
  Code code = kNoCode;                   ///< 10, 20 or 30
  Position end{};                        ///< work coordinates
  std::array<double, 2> centre{};        ///< of an arc, in the plane
  int turns = 0;                         ///< of an arc, + counter-clockwise
  double feed = 0.0, feed_linear = 0.0;  ///< modal where it was read
  std::size_t line = 0, file = 0;
  bool is_open = false;  ///< ,A alone: it ends where the next line meets it
};

struct SavedModal {
  Modal modal;
  bool automatic = false;  ///< M73: restored at the end of the call
};

/// Arcs whose end lies off their radius by more than rounding, and were accepted.
struct MendedArcs {
  std::size_t count = 0;
  double worst = 0.0;  ///< [mm]
  std::size_t line = 0, file = 0;
};

/// What a program has told of limits, and of what has no effect on plans (told once each).
struct ProgramLimits {
  MotionCeiling ceiling;                              ///< of moves that feed, by which printers mean printing
  double travel_acceleration = MotionCeiling::kNone;  ///< [mm/s²] of moves of printers that do not print
  bool unused_told = false;

  bool has_own_travels() const { return travel_acceleration != ceiling.path_acceleration; }
};

/// Programs about the tool's tip (tool_tip.h).
struct TipState {
  Kinematics kinematics;                            ///< of the machine
  RotaryTravel travel = RotaryTravel::unbounded();  ///< of its rotary axes
  toolpace::Chain chain;                            ///< about whose tip the program is; without joints: about the axes
  bool everywhere = false;                          ///< from end to end, whatever the program says
  bool by_vector = false;                           ///< I J K of straight moves point the tool

  bool is_on() const { return !chain.is_identity(); }
};

/// Where a code stands in the program, and how many rows there were before.
struct CodePlace {
  std::size_t line = 0, row = 0;
};

struct State {
  Modal modal;
  Offsets offsets;
  TipState tip;
  Scaling mirror, scale;             ///< G51.1 comes first, then G51; offsets.scaling is both of them
  std::optional<Position> way_home;  ///< the point that G28 or G30 led through last
  Position position{};               ///< of the tool, in work coordinates
  Code plain_motion = 0;             ///< the last one of G0 G1 G2 G3
  int selected_tool = 0;
  bool tool_selected = false;  ///< by a T word, if only T0
  Tool loaded;
  std::map<int, Tool> tools;
  bool has_tool_table = false;
  CycleMemory cycle;
  TurningMemory turning;
  TurningSetup turning_setup;
  Compensation compensation;
  SplineMemory spline;
  std::optional<WaitingMove> waiting;
  std::map<int, OtherSpindle> spindles;  ///< by number, from 1
  MendedArcs mended;
  ProgramLimits limits;
  bool extruder_told = false;         ///< that E is left out has been said
  bool lathe_level_told = false;      ///< that R of a lathe's drilling cycle is a level has been said
  bool increments_told = false;       ///< that a peck is read in least increments has been said
  bool turns_c = false;               ///< the program has moved C as an axis
  bool tool_table_told = false;       ///< that there is no tool table has been said
  bool pocket_told = false;           ///< that the radius of a pocket's tool is not known has been said
  std::optional<CodePlace> tip_code;  ///< of the last M128 that was taken to do nothing
  bool feed_mode_doubtful = false;    ///< G94 of lathes has been read as a feed a minute
  bool units_given = false;           ///< by G20 or G21
  bool chamfer_told = false;          ///< that C of a straight move is a chamfer has been said
};

Position to_machine(const Offsets& offsets, const Position& work);
Position to_work(const Offsets& offsets, const Position& machine);

}  // namespace toolpace::nc
