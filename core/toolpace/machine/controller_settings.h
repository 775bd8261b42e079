#pragma once
/// Settings of real controllers, under their own names: what a model of each needs.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/machine/controller.h"
#include "toolpace/machine/settings_text.h"

namespace toolpace {

using XyzValues = std::array<double, 3>;

/// grbl 1.1 and grblHAL; the values here are grbl's own defaults.
struct GrblSettings {
  double idle_delay = 0.025;                           ///< $1 [s]; 0.255 stands for drives that are never let go
  double junction_deviation = 0.01;                    ///< $11 [mm]
  double arc_tolerance = 0.002;                        ///< $12 [mm]
  double laser = 0.0;                                  ///< $32: 1 = M3 to M5 do not stop
  XyzValues steps = {250, 250, 250};                   ///< $100 … [1/mm]
  XyzValues rate = {500 / 60., 500 / 60., 500 / 60.};  ///< $110 … [mm/s]
  XyzValues acceleration = {10, 10, 10};               ///< $120 … [mm/s²]
  double buffer = 16;                                  ///< blocks of the planner's ring; grblHAL's $398, 100 there
};

struct KlipperSettings {
  double max_velocity = 0, max_accel = 0;      ///< [mm/s, mm/s²]; a printer.cfg has to give both
  double max_z_velocity = 0, max_z_accel = 0;  ///< [mm/s, mm/s²]; those along the path where the file has none
  double square_corner_velocity = 5.0;         ///< [mm/s]
  double minimum_cruise_ratio = 0.5;           ///< 0 … 1
  double arc_resolution = 1.0;                 ///< [gcode_arcs] resolution [mm]
  bool has_arcs = false;                       ///< without [gcode_arcs] there is no G2 and no G3
  std::string kinematics = "cartesian";
  bool has_extruder = false;                 ///< [extruder] is there
  double nozzle = 0.4, filament = 1.75;      ///< [extruder] nozzle_diameter, filament_diameter [mm]
  double max_extrude_only_velocity = 0;      ///< [extruder] [mm/s]; 0 = as the others make it
  double max_extrude_only_accel = 0;         ///< [extruder] [mm/s²]; 0 = as the others make it
  double instantaneous_corner_velocity = 1;  ///< [extruder] [mm/s]
};

/// Marlin 2.1 with its junction deviation; the values here are those of its sample configuration.
struct MarlinSettings {
  XyzValues steps = {80, 80, 400};                   ///< M92 [1/mm]
  XyzValues rate = {300, 300, 5};                    ///< M203 [mm/s]
  XyzValues axis_acceleration = {3000, 3000, 100};   ///< M201 [mm/s²]
  double acceleration = 3000;                        ///< M204 P [mm/s²] of moves that print
  double travel_acceleration = 3000;                 ///< M204 T [mm/s²]
  double junction_deviation = 0.013;                 ///< M205 J [mm]
  double minimum_rate = 0, minimum_travel_rate = 0;  ///< M205 S, T [mm/s]
  double buffer = 16;                                ///< BLOCK_BUFFER_SIZE; reports do not tell it
};

/// LinuxCNC 2.9. Axes that the file does not name move without limits.
struct LinuxcncSettings {
  double period = 0.001;         ///< [EMCMOT] SERVO_PERIOD [s]
  double task_cycle = 0.1;       ///< [TASK] CYCLE_TIME [s] of the interpreter
  double velocity = 0;           ///< [TRAJ] MAX_LINEAR_VELOCITY [mm/s]; infinite = none
  AxisVector axis_velocity;      ///< [mm/s, rad/s]
  AxisVector axis_acceleration;  ///< [mm/s², rad/s²]
  double depth = 50;             ///< [TRAJ] ARC_BLEND_OPTIMIZATION_DEPTH [blocks]
  double arc_blends = 1;         ///< [TRAJ] ARC_BLEND_ENABLE
  double feed_scale = 1;         ///< [DISPLAY] MAX_FEED_OVERRIDE: corners are laid out for that
  double kink_ratio = 0.1;       ///< [TRAJ] ARC_BLEND_KINK_RATIO, 0.001 … 0.7071
  double gap_cycles = 4;         ///< [TRAJ] ARC_BLEND_GAP_CYCLES
  double ramp_frequency = 100;   ///< [TRAJ] ARC_BLEND_RAMP_FREQ [Hz]
  std::string startup_code;      ///< [RS274NGC] RS274NGC_STARTUP_CODE
  double blend_tolerance = 0;    ///< [mm] of its G64 P, in the place of what the text says; 0 = it has none
};

/// One setting that can be tried with another value.
struct ControllerParameter {
  std::string key;                  ///< as the controller has it: "$120", "[printer] max_accel", "M201 X"
  std::string title;                ///< "X acceleration"
  const char* unit;                 ///< of the file, for people: "mm/min", "1" for a ratio; empty for what is on or off
  double size;                      ///< what one such unit is inside
  double* value;                    ///< inside the settings, in mm and s
  double least, most;               ///< what the controller takes, in the file's unit
  std::vector<double> others = {};  ///< values worth trying besides, in the file's unit
};

/// What a settings file says, and what it leaves open.
struct ControllerSettings {
  Controller controller = Controller::grbl;
  std::variant<GrblSettings, KlipperSettings, MarlinSettings, LinuxcncSettings> values;
  std::vector<std::string> used;       ///< keys that count here
  std::vector<std::string> unused;     ///< keys of the controller that change no cycle time
  std::vector<std::string> unknown;    ///< keys that it does not have
  std::vector<std::string> defaulted;  ///< keys that are missing: the controller's own default holds
  Diagnostics warnings;
};

/// The parameters that change cycle times, pointing into `settings`.
std::vector<ControllerParameter> parameters(ControllerSettings& settings);

/// Reads settings in the controller's own form: an answer to $$, a printer.cfg, a report of M503, a LinuxCNC .ini, with what
/// consoles and senders put around them.
///
/// @param controller  whose they shall be; none = as the text tells
/// @return usage errors: "settings-foreign" for those of another controller, named for what they are; "settings-unknown" where
///         nothing tells whose they are; "import-value" for what is no number or out of range; "settings-missing" for a key that
///         has no default
Result<ControllerSettings> parse_controller_settings(std::string_view text, const std::string& name,
                                                     std::optional<Controller> controller = {},
                                                     const ReadIncluded& included = {});
/// The same from a file ("-" = standard input), with those that it includes. Errors besides: io, cancelled.
Result<ControllerSettings> read_controller_settings(const std::filesystem::path& file,
                                                    std::optional<Controller> controller = {},
                                                    const Monitor& monitor = {});

}  // namespace toolpace
