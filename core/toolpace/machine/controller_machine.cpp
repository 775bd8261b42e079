#include "toolpace/machine/controller_machine.h"

#include <cmath>

namespace toolpace {
namespace {

void add_axes(Machine& machine, const XyzValues& steps, const XyzValues& rate, const XyzValues& acceleration) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    machine.axes[k].steps_per_unit = steps[k];
    machine.axes[k].speed = rate[k];
    machine.axes[k].acceleration = acceleration[k];
  }
}

void add_limits(Setup& setup, const GrblSettings& grbl) {
  add_axes(setup.machine, grbl.steps, grbl.rate, grbl.acceleration);
  setup.options.corner.rule = CornerRule::junction;
  setup.options.corner.junction_deviation = grbl.junction_deviation;
}

void add_limits(Setup& setup, const KlipperSettings& klipper) {
  setup.machine.path.speed = klipper.max_velocity;
  setup.machine.path.acceleration = klipper.max_accel;
  // No axis is faster than the path: that X and Y have this speed says that they are there, and changes no plan but one through
  // the tube, which keeps its distance from every limit, by hundredths of a per cent.
  setup.machine.axes[0].speed = setup.machine.axes[1].speed = klipper.max_velocity;
  setup.machine.axes[2].speed = klipper.max_z_velocity;
  setup.machine.axes[2].acceleration = klipper.max_z_accel;
  setup.options.corner.rule = CornerRule::junction;
  const double corner = klipper.square_corner_velocity;
  setup.options.corner.junction_deviation = corner * corner * (std::sqrt(2.0) - 1.0) / klipper.max_accel;
}

void add_limits(Setup& setup, const MarlinSettings& marlin) {
  add_axes(setup.machine, marlin.steps, marlin.rate, marlin.axis_acceleration);
  setup.machine.path.acceleration = marlin.acceleration;
  setup.options.corner.rule = CornerRule::junction;
  setup.options.corner.junction_deviation = marlin.junction_deviation;
}

void add_limits(Setup& setup, const LinuxcncSettings& linuxcnc) {
  setup.machine.period = linuxcnc.period;
  setup.machine.path.speed = linuxcnc.velocity;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    setup.machine.axes[k].speed = linuxcnc.axis_velocity[static_cast<Eigen::Index>(k)];
    setup.machine.axes[k].acceleration = linuxcnc.axis_acceleration[static_cast<Eigen::Index>(k)];
  }
}

}  // namespace

Setup controller_setup(const ControllerSettings& settings) {
  Setup setup;
  setup.options.law = LawKind::trapezoid;
  std::visit([&](const auto& values) { add_limits(setup, values); }, settings.values);
  PathLimits& path = setup.machine.path;
  path.deceleration = path.acceleration;
  return setup;
}

}  // namespace toolpace
