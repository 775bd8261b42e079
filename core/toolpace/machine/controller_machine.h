#pragma once
/// The limits of a real controller as a machine.

#include "toolpace/machine/controller_settings.h"
#include "toolpace/machine/setup.h"

namespace toolpace {

/// The same speeds, accelerations and steps, with no limit where the controller has none: no jerk, and along the path only what
/// holds along the path there. The law is the trapezoid.
Setup controller_setup(const ControllerSettings& settings);

}  // namespace toolpace
