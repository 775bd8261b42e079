#pragma once
/// Which axis each joint of a LinuxCNC machine moves, as its settings tell it.

#include <array>
#include <string>
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

}  // namespace toolpace
