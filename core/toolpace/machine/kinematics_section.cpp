#include "toolpace/machine/kinematics_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/base/nearest_word.h"
#include "toolpace/base/numbers.h"
#include "toolpace/machine/toml_values.h"

namespace toolpace::detail {
namespace {

constexpr std::size_t kMostJoints = 2;
constexpr double kFarthest = 1e6, kLongestTool = 1e4;  // [mm]

class KinematicsReader {
 public:
  KinematicsReader(const std::string& file, UnknownKeys unknown) : file_(file), unknown_(unknown) {}

  Result<Kinematics> read(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table) {
      fail("'kinematics' must be a table", "write [kinematics]", node);
      return tl::unexpected(*error_);
    }
    for (auto&& [key, value] : *table) {
      const bool good = key.str() == "rotary"        ? read_rotary(value)
                        : key.str() == "tool_mm"     ? read_tool(value)
                        : key.str() == "orientation" ? read_orientation(value)
                                                     : unknown_key(key, {"rotary", "tool_mm", "orientation"});
      if (!good) return tl::unexpected(*error_);
    }
    return result_;
  }

 private:
  bool fail(std::string message, std::string remedy, const toml::node& node, const char* code = "machine-value") {
    return fail_at(std::move(message), std::move(remedy), node.source(), code);
  }

  bool fail_at(std::string message, std::string remedy, const toml::source_region& source, const char* code) {
    error_ = Error{ErrorKind::usage, code, std::move(message), std::move(remedy), place_in(file_, source), {}};
    return false;
  }

  bool unknown_key(const toml::key& key, const std::vector<std::string>& known) {
    if (unknown_ == UnknownKeys::pass_over) return true;
    return fail_at(fmt::format("there is no key '{}'", key.str()),
                   fmt::format("did you mean '{}'?", nearest_word(key.str(), known)), key.source(), "machine-key");
  }

  bool read_tool(const toml::node& node) {
    const auto length = number_of(&node);
    if (!length || !(*length >= 0 && *length <= kLongestTool)) {
      return fail(fmt::format("tool_mm is {}, but must be 0 to {:g} mm", shown(node), kLongestTool),
                  "give the length from the spindle's nose to the tip", node);
    }
    result_.chain.tool_length = *length;
    result_.tells_tool_length = true;
    return true;
  }

  bool read_orientation(const toml::node& node) {
    const auto* text = node.as_string();
    const auto orientation = text ? orientation_named(text->get()) : std::nullopt;
    if (!orientation)
      return fail("orientation must be \"axes\" or \"plane\"",
                  "say whether the rotary axes turn evenly between blocks, or the tool in a plane", node);
    result_.chain.orientation = *orientation;
    return true;
  }

  bool read_rotary(const toml::node& node) {
    const toml::array* list = node.as_array();
    const char* const remedy =
        "write rotary = [{axis = \"A\", side = \"table\", direction = [1, 0, 0], point_mm = [0, 0, 0]}]";
    if (!list) return fail(fmt::format("rotary is {}, but must be a list", shown(node)), remedy, node);
    if (list->size() > kMostJoints)
      return fail(fmt::format("{} rotary axes, but a chain has two at most", list->size()), remedy, node);
    for (const toml::node& joint : *list) {
      const toml::table* table = joint.as_table();
      if (!table) return fail(fmt::format("{} stands where a rotary axis is due", shown(joint)), remedy, joint);
      if (!read_joint(*table)) return false;
    }
    return true;
  }

  bool read_joint(const toml::table& table) {
    RotaryJoint joint{kAxisCount, ChainSide::table, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    bool has_side = false;
    for (auto&& [key, value] : table) {
      bool good = true;
      if (key.str() == "axis") {
        good = read_axis(value, joint.axis);
      } else if (key.str() == "side") {
        good = has_side = read_side(value, joint.side);
      } else if (key.str() == "direction" || key.str() == "point_mm") {
        good = read_vector(std::string(key.str()), value, key.str() == "direction" ? joint.direction : joint.point);
      } else {
        good = unknown_key(key, {"axis", "side", "direction", "point_mm"});
      }
      if (!good) return false;
    }
    const double norm = joint.direction.norm();
    if (joint.axis == kAxisCount || !has_side || !(norm > 0)) {
      return fail("a rotary axis needs axis, side and a direction other than 0",
                  "write {axis = \"A\", side = \"table\", direction = [1, 0, 0]}", table);
    }
    joint.direction /= norm;
    result_.chain.joints.push_back(joint);
    return true;
  }

  bool read_axis(const toml::node& node, std::size_t& axis) {
    const auto* text = node.as_string();
    const std::string name = text ? text->get() : std::string();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      if (is_rotary(k) && name == std::string(1, kAxisNames[k])) axis = k;
    }
    if (axis == kAxisCount) return fail("axis must be \"A\", \"B\" or \"C\"", "name the rotary axis", node);
    const auto& joints = result_.chain.joints;
    const bool twice = std::any_of(joints.begin(), joints.end(), [&](const RotaryJoint& j) { return j.axis == axis; });
    return !twice || fail(fmt::format("{} stands twice in the chain", name), "give each rotary axis once", node);
  }

  bool read_side(const toml::node& node, ChainSide& side) {
    const auto* text = node.as_string();
    if (!text || (text->get() != "table" && text->get() != "head"))
      return fail("side must be \"table\" or \"head\"", "say whether it carries the workpiece or the spindle", node);
    side = text->get() == "head" ? ChainSide::head : ChainSide::table;
    return true;
  }

  bool read_vector(const std::string& key, const toml::node& node, Eigen::Vector3d& vector) {
    const toml::array* list = node.as_array();
    bool good = list && list->size() == 3;
    for (std::size_t k = 0; good && k < 3; ++k) {
      const auto value = number_of(list->get(k));
      good = value && std::fabs(*value) <= kFarthest;
      if (good) vector[static_cast<Eigen::Index>(k)] = *value;
    }
    return good ||
           fail(fmt::format("{} must be three numbers [x, y, z] up to {:g}", key, kFarthest), "write [0, 0, 1]", node);
  }

  const std::string& file_;
  UnknownKeys unknown_;
  Kinematics result_;
  std::optional<Error> error_;
};

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", to_text(v.x()), to_text(v.y()), to_text(v.z()));
}

}  // namespace

Result<Kinematics> read_kinematics(const toml::node& node, const std::string& file, UnknownKeys unknown) {
  return KinematicsReader(file, unknown).read(node);
}

std::string kinematics_text(const Kinematics& kinematics) {
  if (kinematics == Kinematics{}) return {};
  std::string text = "[kinematics]\nrotary = [";
  for (const RotaryJoint& j : kinematics.chain.joints) {
    text += fmt::format("\n  {{axis = \"{}\", side = \"{}\", direction = {}, point_mm = {}}},", kAxisNames[j.axis],
                        j.side == ChainSide::head ? "head" : "table", vector_text(j.direction), vector_text(j.point));
  }
  text += kinematics.chain.joints.empty() ? "]\n" : "\n]\n";
  if (kinematics.tells_tool_length) text += fmt::format("tool_mm = {}\n", to_text(kinematics.chain.tool_length));
  if (kinematics.chain.orientation == Orientation::plane) text += "orientation = \"plane\"\n";
  return text;
}

}  // namespace toolpace::detail
