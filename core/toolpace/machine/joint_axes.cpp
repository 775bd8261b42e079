#include "toolpace/machine/joint_axes.h"

#include <cctype>
#include <string_view>

namespace toolpace {
namespace {

constexpr std::string_view kAllLetters = "XYZABCUVW";
constexpr std::size_t kMostJoints = 16;  // of LinuxCNC

/// The letter at each place is the axis of the joint with that number; letters that are no axes here (U, V, W) count, too.
void assign(JointAxes& joints, std::string_view letters) {
  std::size_t joint = 0;
  for (const char letter : letters) {
    if (std::isspace(static_cast<unsigned char>(letter))) continue;
    if (joint == kMostJoints) return;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (kAxisNames[axis] == letter) joints.of_axis[axis].push_back(joint);
    }
    ++joint;
  }
}

/// What stands behind "coordinates=" in the words of a kinematics module; empty where nothing does.
std::string_view coordinates_in(std::string_view module) {
  constexpr std::string_view kKey = "COORDINATES=";
  const std::size_t at = module.find(kKey);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = module.substr(at + kKey.size());
  return rest.substr(0, rest.find_first_of(" \t#;"));
}

}  // namespace

JointAxes joint_axes(const Importer& settings) {
  using Source = JointAxes::Source;
  JointAxes joints;
  if (const ImportedValue* kinematics = settings.find("KINS.KINEMATICS")) {
    const std::string module = upper(kinematics->text);
    const std::string_view letters = coordinates_in(module);
    const bool is_trivial =
        module.starts_with("TRIVKINS") || module.starts_with("GENTRIVKINS") || module.starts_with("GANTRYKINS");
    joints.source = is_trivial || !letters.empty() ? Source::kinematics : Source::unknown;
    if (joints.source == Source::kinematics) assign(joints, letters.empty() ? kAllLetters : letters);
    return joints;
  }
  if (const ImportedValue* coordinates = settings.find("TRAJ.COORDINATES")) {
    joints.source = Source::coordinates;
    assign(joints, upper(coordinates->text.substr(0, coordinates->text.find_first_of("#;"))));
    return joints;
  }
  assign(joints, kAllLetters);
  return joints;
}

}  // namespace toolpace
