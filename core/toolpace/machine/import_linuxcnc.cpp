#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "toolpace/base/axis_unit.h"
#include "toolpace/base/numbers.h"
#include "toolpace/machine/importer.h"
#include "toolpace/machine/joint_axes.h"
#include "toolpace/machine/read_machine.h"
#include "toolpace/machine/settings_text.h"

namespace toolpace {
namespace {

constexpr double kNoLimit = 1e9;  // LinuxCNC's own default is 1e99

/// The text where it is UTF-8, as TOML wants it; else with ? for every letter outside of ASCII.
std::string as_name(std::string text) {
  Setup setup;
  setup.machine.name = text;
  if (format_setup(setup)) return text;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) >= 0x80 || static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return text;
}

/// Reads the limits of axes: those of [AXIS_X], else those of the joints that move X.
class AxisImport {
 public:
  AxisImport(Importer& importer, double length) : importer_(importer), joints_(joint_axes(importer)), length_(length) {}

  void run() {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) add(axis);
    warn_about_joints();
  }

 private:
  void add(std::size_t axis) {
    const std::string section = std::string("axes.") + kAxisNames[axis];
    const AxisUnit& unit = axis_unit(axis);
    const auto take = [&](const std::string& key, const char* name, std::optional<double> none = {}) {
      const auto value = strictest(axis, name, std::less<>(), none);
      if (value) importer_.put(section, key, *value);
    };
    take(std::string("max_speed_") + unit.key[1], ".MAX_VELOCITY");
    take(std::string("max_acceleration_") + unit.key[2], ".MAX_ACCELERATION");
    take(std::string("max_jerk_") + unit.key[3], ".MAX_JERK", 0.0);
    const auto least = strictest(axis, ".MIN_LIMIT", std::greater<>());
    const auto most = strictest(axis, ".MAX_LIMIT", std::less<>());
    if (!least && !most) return;
    importer_.set_travel(axis, least && *least > -kNoLimit ? *least : -kUnlimited,
                         most && *most < kNoLimit ? *most : kUnlimited);
  }

  /// The value of the axis, else the one among its joints that leaves the least room.
  template <class Stricter>
  std::optional<double> strictest(std::size_t axis, const std::string& name, Stricter stricter,
                                  std::optional<double> none = {}) {
    const double unit = is_rotary(axis) ? 1.0 : length_;
    std::optional<double> best;
    std::string best_key;
    for (const std::string& key : keys_of_axis(importer_, joints_, axis, name)) {
      guessed_ |= key.starts_with("JOINT_");
      const auto value = importer_.take(key, unit);
      if (!value || value == none || (best && !stricter(*value, *best))) continue;
      best = value;
      best_key = key;
    }
    if (best) importer_.take(best_key, unit);  // an error is about this one
    return best;
  }

  void warn_about_joints() {
    using Source = JointAxes::Source;
    if (joints_.source == Source::guess && guessed_) {
      importer_.warn(
          "joint-axis-guessed",
          "no [KINS] KINEMATICS and no [TRAJ] COORDINATES say which axis a joint moves: JOINT_0 is taken as X, "
          "JOINT_1 as Y, and so on",
          "add [KINS] KINEMATICS, or give each axis its own limits in [AXIS_X] and so on", 0);
    }
    if (joints_.source != Source::unknown) return;
    const ImportedValue& kinematics = *importer_.find("KINS.KINEMATICS");
    for (const auto& [key, value] : importer_.values()) {
      if (!key.starts_with("JOINT_") || !key.ends_with(".MAX_VELOCITY")) continue;
      return importer_.warn(
          "joint-axis-unknown",
          fmt::format("the joints of {} are no axes, so the limits in [JOINT_0] and so on are not used",
                      kinematics.text),
          "give each axis its own limits in [AXIS_X] and so on", kinematics.line);
    }
  }

  Importer& importer_;
  JointAxes joints_;
  double length_;  ///< [mm] of a unit of the file
  bool guessed_ = false;
};

}  // namespace

Result<Setup> import_linuxcnc_ini(std::string_view text, const std::string& name) {
  return import_linuxcnc_values(read_ini_values(text), name);
}

Result<Setup> import_linuxcnc_values(ImportedValues values, const std::string& name) {
  Importer importer(std::move(values), name);
  const double length = length_unit(importer);
  importer.take("path", "max_speed_mm_s", {kPathVelocityKeys[0], kPathVelocityKeys[1], kPathVelocityKeys[2]}, length);
  importer.take("path", "max_acceleration_mm_s2", {"TRAJ.MAX_LINEAR_ACCELERATION", "TRAJ.MAX_ACCELERATION"}, length);
  importer.take("path", "max_jerk_mm_s3", {"TRAJ.MAX_LINEAR_JERK"}, length, 0.0);
  importer.take("machine", "period_ms", {"EMCMOT.SERVO_PERIOD"}, 1e-6);
  AxisImport(importer, length).run();
  if (const ImportedValue* title = importer.find("EMC.MACHINE")) importer.setup().machine.name = as_name(title->text);
  return importer.finish("a LinuxCNC configuration");
}

}  // namespace toolpace
