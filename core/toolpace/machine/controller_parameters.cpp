/// The tables of settings by which each controller is read and tried.

#include <string>

#include "toolpace/machine/controller_settings.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace {
namespace {

using Parameters = std::vector<ControllerParameter>;

constexpr double kMostSetting = 1e9;
constexpr double kLeastSetting = 1e-6;
constexpr const char* kBuiltIn = "1/mm";  // of what is built so: nobody tries another value
constexpr const char* kSwitch = "";       // the unit of what is on or off

void add_by_axis(Parameters& list, const std::string& head, const char* title, const char* unit, double size,
                 XyzValues& values, bool by_letter) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string end = by_letter ? std::string(1, kAxisNames[k]) : std::to_string(k);
    list.push_back(
        {head + end, std::string(1, kAxisNames[k]) + " " + title, unit, size, &values[k], kLeastSetting, kMostSetting});
  }
}

Parameters list_of(GrblSettings& s, Controller controller) {
  Parameters list;
  const bool is_hal = controller == Controller::grblhal;
  if (!is_hal) list.push_back({"$1", "step idle delay", "ms", 1e-3, &s.idle_delay, 0, 65535, {255}});
  list.push_back({"$11", "junction deviation", "mm", 1, &s.junction_deviation, 0, kMostSetting});
  list.push_back({"$12", "arc tolerance", "mm", 1, &s.arc_tolerance, kLeastSetting, kMostSetting});
  list.push_back({"$32", "laser mode", kSwitch, 1, &s.laser, 0, 2});
  add_by_axis(list, "$10", "steps", "1/mm", 1, s.steps, false);
  add_by_axis(list, "$11", "rate", "mm/min", kPerMinute, s.rate, false);
  add_by_axis(list, "$12", "acceleration", "mm/s²", 1, s.acceleration, false);
  if (is_hal) list.push_back({"$398", "planner buffer", "blocks", 1, &s.buffer, 30, 1000});
  return list;
}

Parameters list_of(KlipperSettings& s) {
  Parameters list = {
      {"[printer] max_velocity", "speed", "mm/s", 1, &s.max_velocity, kLeastSetting, kMostSetting},
      {"[printer] max_accel", "acceleration", "mm/s²", 1, &s.max_accel, kLeastSetting, kMostSetting},
      {"[printer] max_z_velocity", "Z speed", "mm/s", 1, &s.max_z_velocity, kLeastSetting, kMostSetting},
      {"[printer] max_z_accel", "Z acceleration", "mm/s²", 1, &s.max_z_accel, kLeastSetting, kMostSetting},
      {"[printer] square_corner_velocity", "square corner velocity", "mm/s", 1, &s.square_corner_velocity, 0,
       kMostSetting},
      {"[printer] minimum_cruise_ratio", "minimum cruise ratio", "1", 1, &s.minimum_cruise_ratio, 0, 0.999, {0}}};
  if (s.has_arcs)
    list.push_back({"[gcode_arcs] resolution", "arc resolution", "mm", 1, &s.arc_resolution, 1e-3, kMostSetting});
  if (!s.has_extruder) return list;
  list.insert(list.end(),
              {{"[extruder] nozzle_diameter", "nozzle", kBuiltIn, 1, &s.nozzle, kLeastSetting, kMostSetting},
               {"[extruder] filament_diameter", "filament", kBuiltIn, 1, &s.filament, kLeastSetting, kMostSetting},
               {"[extruder] max_extrude_only_velocity", "speed of the extruder alone", "mm/s", 1,
                &s.max_extrude_only_velocity, 0, kMostSetting},
               {"[extruder] max_extrude_only_accel", "acceleration of the extruder alone", "mm/s²", 1,
                &s.max_extrude_only_accel, 0, kMostSetting},
               {"[extruder] instantaneous_corner_velocity", "extruder's step of speed at corners", "mm/s", 1,
                &s.instantaneous_corner_velocity, 0, kMostSetting}});
  return list;
}

Parameters list_of(MarlinSettings& s) {
  Parameters list;
  add_by_axis(list, "M92 ", "steps", "1/mm", 1, s.steps, true);
  add_by_axis(list, "M203 ", "feedrate", "mm/s", 1, s.rate, true);
  add_by_axis(list, "M201 ", "acceleration", "mm/s²", 1, s.axis_acceleration, true);
  list.push_back({"M204 P", "printing acceleration", "mm/s²", 1, &s.acceleration, kLeastSetting, kMostSetting});
  list.push_back({"M204 T", "travel acceleration", "mm/s²", 1, &s.travel_acceleration, kLeastSetting, kMostSetting});
  list.push_back({"M205 J", "junction deviation", "mm", 1, &s.junction_deviation, 0, kMostSetting});
  list.push_back({"M205 S", "minimum feedrate", "mm/s", 1, &s.minimum_rate, 0, kMostSetting});
  list.push_back({"M205 T", "minimum travel feedrate", "mm/s", 1, &s.minimum_travel_rate, 0, kMostSetting});
  return list;
}

Parameters list_of(LinuxcncSettings& s) {
  Parameters list = {
      {"[TRAJ] MAX_LINEAR_VELOCITY", "path velocity", "mm/s", 1, &s.velocity, kLeastSetting, kUnlimited},
      {"[TRAJ] ARC_BLEND_OPTIMIZATION_DEPTH", "look-ahead", "blocks", 1, &s.depth, 1, 100},
      {"[TRAJ] ARC_BLEND_ENABLE", "arc blends", kSwitch, 1, &s.arc_blends, 0, 1, {0, 1}},
      {"[TRAJ] ARC_BLEND_KINK_RATIO", "kink that passes as tangent", "1", 1, &s.kink_ratio, 0.001, 0.7071},
      {"[DISPLAY] MAX_FEED_OVERRIDE", "most feed override", "1", 1, &s.feed_scale, 1e-3, 1000},
      {"[TRAJ] ARC_BLEND_GAP_CYCLES", "least length of a blend", "cycles", 1, &s.gap_cycles, 0, kMostSetting},
      {"[TRAJ] ARC_BLEND_RAMP_FREQ", "ramp frequency", "Hz", 1, &s.ramp_frequency, 0, kMostSetting},
      {"[TASK] CYCLE_TIME", "cycle of the interpreter", "s", 1, &s.task_cycle, 1e-6, 10},
      {"[EMCMOT] SERVO_PERIOD", "servo period", "ns", 1e-9, &s.period, 1e4, 1e8}};
  if (s.blend_tolerance > 0)
    list.push_back({"G64 P", "blend tolerance", "mm", 1, &s.blend_tolerance, kLeastSetting, kMostSetting});
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const std::string section = std::string("[AXIS_") + kAxisNames[k] + "] ", letter(1, kAxisNames[k]);
    const double size = is_rotary(k) ? kRadiansPerDegree : 1.0;
    list.push_back({section + "MAX_VELOCITY", letter + " velocity", is_rotary(k) ? "deg/s" : "mm/s", size,
                    &s.axis_velocity[axis], kLeastSetting, kUnlimited});
    list.push_back({section + "MAX_ACCELERATION", letter + " acceleration", is_rotary(k) ? "deg/s²" : "mm/s²", size,
                    &s.axis_acceleration[axis], kLeastSetting, kUnlimited});
  }
  return list;
}

}  // namespace

Parameters parameters(ControllerSettings& settings) {
  if (auto* grbl = std::get_if<GrblSettings>(&settings.values)) return list_of(*grbl, settings.controller);
  if (auto* klipper = std::get_if<KlipperSettings>(&settings.values)) return list_of(*klipper);
  if (auto* marlin = std::get_if<MarlinSettings>(&settings.values)) return list_of(*marlin);
  return list_of(std::get<LinuxcncSettings>(settings.values));
}

}  // namespace toolpace
