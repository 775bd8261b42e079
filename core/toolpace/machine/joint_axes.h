#pragma once
/// Which axis each joint of a LinuxCNC machine moves, as its settings tell it.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/machine/importer.h"

namespace toolpace {

/// Joints by axis: none, one, or the several of a gantry.
struct JointAxes {
  enum class Source : std::uint8_t {
    kinematics,   ///< [KINS] KINEMATICS says it: by coordinates=, or as that of trivkins without any does
    coordinates,  ///< no [KINS] KINEMATICS: [TRAJ] COORDINATES in its order
    guess,        ///< neither: X Y Z A B C
    unknown,      ///< other kinematics, whose joints are no axes: none is told
  };

  Source source = Source::guess;
  std::array<std::vector<std::size_t>, kAxisCount> of_axis;
};

/// @source LinuxCNC, man page kins(9): "Joint numbers are assigned sequentially according to the axis letters specified with
/// the coordinates= parameter. If the coordinates= parameter is omitted, joint numbers are assigned sequentially to every
/// known axis letter (xyzabcuvw)."
JointAxes joint_axes(const Importer& settings);

/// The keys that tell a limit of an axis: its own, as AXIS_X.MAX_VELOCITY, else those of the joints that move it; only those that
/// are there. @param limit  ".MAX_VELOCITY"
std::vector<std::string> keys_of_axis(const Importer& settings, const JointAxes& joints, std::size_t axis,
                                      std::string_view limit);

/// The keys that tell the speed along the path: the first one that is there counts.
inline constexpr std::array<std::string_view, 3> kPathVelocityKeys = {"TRAJ.MAX_LINEAR_VELOCITY", "TRAJ.MAX_VELOCITY",
                                                                      "DISPLAY.MAX_LINEAR_VELOCITY"};

/// [mm] of a unit of length of the file: [TRAJ] LINEAR_UNITS, a name, or how many of them are a millimetre. What is neither is
/// refused.
double length_unit(Importer& settings);

}  // namespace toolpace
