#include "toolpace/machine/joint_axes.h"

#include <cctype>
#include <string_view>

#include "toolpace/base/numbers.h"

namespace toolpace {
namespace {

constexpr std::string_view kAllLetters = "XYZABCUVW";
constexpr std::size_t kMostJoints = 16;  // of LinuxCNC
constexpr double kMmPerInch = 25.4;
constexpr double kLeastUnits = 1e-3, kMostUnits = 1e3;  // [1/mm] metres to micrometres

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

std::vector<std::string> keys_of_axis(const Importer& settings, const JointAxes& joints, std::size_t axis,
                                      std::string_view limit) {
  const std::string own = std::string("AXIS_") + kAxisNames[axis] + std::string(limit);
  if (settings.find(own)) return {own};
  std::vector<std::string> keys;
  for (const std::size_t joint : joints.of_axis[axis]) {
    const std::string key = "JOINT_" + std::to_string(joint) + std::string(limit);
    if (settings.find(key)) keys.push_back(key);
  }
  return keys;
}

double length_unit(Importer& importer) {
  constexpr const char* kKey = "TRAJ.LINEAR_UNITS";
  const ImportedValue* units = importer.find(kKey);
  if (!units) return 1.0;
  const std::string name = upper(units->text.substr(0, units->text.find_first_of(" \t;#(")));
  if (name == "MM" || name == "METRIC") return 1.0;
  if (name == "INCH" || name == "IN" || name == "IMPERIAL") return kMmPerInch;
  const auto number = parse_number(name);
  if (number && *number >= kLeastUnits && *number <= kMostUnits) return 1.0 / *number;
  importer.refuse(kKey, "mm, inch or the number of units in a millimetre");
  return 1.0;
}

}  // namespace toolpace
