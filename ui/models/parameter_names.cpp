#include "models/parameter_names.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>

namespace toolpace::ui {
namespace {

struct Name {
  const char* key;
  const char* title;
};

constexpr std::array kServoNames = {
    Name{"kv_1_s", QT_TRANSLATE_NOOP("ParameterNames", "Position gain of %1")},
    Name{"velocity_feed_forward", QT_TRANSLATE_NOOP("ParameterNames", "Speed feed forward of %1")},
    Name{"acceleration_feed_forward", QT_TRANSLATE_NOOP("ParameterNames", "Acceleration feed forward of %1")},
    Name{"bandwidth_hz", QT_TRANSLATE_NOOP("ParameterNames", "Bandwidth of %1")},
    Name{"damping", QT_TRANSLATE_NOOP("ParameterNames", "Damping of %1")},
    Name{"backlash_mm", QT_TRANSLATE_NOOP("ParameterNames", "Backlash of %1")},
    Name{"backlash_deg", QT_TRANSLATE_NOOP("ParameterNames", "Backlash of %1")},
    Name{"resonance_hz", QT_TRANSLATE_NOOP("ParameterNames", "Resonance of %1")},
    Name{"resonance_damping", QT_TRANSLATE_NOOP("ParameterNames", "Damping of the resonance of %1")}};

constexpr std::array kPathNames = {
    Name{"machine.period_ms", QT_TRANSLATE_NOOP("ParameterNames", "Interpolation period")},
    Name{"machine.tool_change_s", QT_TRANSLATE_NOOP("ParameterNames", "Time of a tool change")},
    Name{"rapid_percent", QT_TRANSLATE_NOOP("ParameterNames", "Rapid override")},
    Name{"override_percent", QT_TRANSLATE_NOOP("ParameterNames", "Feed override")},
    Name{"path.max_speed_mm_s", QT_TRANSLATE_NOOP("ParameterNames", "Top speed of the path")},
    Name{"path.max_acceleration_mm_s2", QT_TRANSLATE_NOOP("ParameterNames", "Acceleration of the path")},
    Name{"path.max_deceleration_mm_s2", QT_TRANSLATE_NOOP("ParameterNames", "Deceleration of the path")},
    Name{"path.max_jerk_mm_s3", QT_TRANSLATE_NOOP("ParameterNames", "Jerk of the path")},
    Name{"path.max_jerk_deceleration_mm_s3", QT_TRANSLATE_NOOP("ParameterNames", "Jerk, slowing down")},
    Name{"path.fine_acceleration_mm_s2",
         QT_TRANSLATE_NOOP("ParameterNames", "Acceleration of the path, most accurate")},
    Name{"law.tacc_ms", QT_TRANSLATE_NOOP("ParameterNames", "Acceleration time")},
    Name{"law.tdec_ms", QT_TRANSLATE_NOOP("ParameterNames", "Deceleration time")},
    Name{"lookahead.tolerance_mm", QT_TRANSLATE_NOOP("ParameterNames", "Tolerance")},
    Name{"lookahead.junction_deviation_mm", QT_TRANSLATE_NOOP("ParameterNames", "Junction deviation")},
    Name{"feed_override_percent", QT_TRANSLATE_NOOP("ParameterNames", "Feed override")}};

}  // namespace

QString parameter_name(const std::string& key) {
  for (const Name& name : kPathNames) {
    if (key == name.key) return QCoreApplication::translate("ParameterNames", name.title);
  }
  const QStringList parts = QString::fromStdString(key).split('.');
  if (parts.size() == 3 && parts[0] == "servo") {
    for (const Name& name : kServoNames) {
      if (parts[2] == QLatin1String(name.key))
        return QCoreApplication::translate("ParameterNames", name.title).arg(parts[1]);
    }
  }
  if (parts.size() != 3 || parts[0] != "axes") return QString::fromStdString(key);
  if (parts[2].startsWith("max_speed"))
    return QCoreApplication::translate("ParameterNames", "Speed of %1").arg(parts[1]);
  if (parts[2].startsWith("max_acceleration"))
    return QCoreApplication::translate("ParameterNames", "Acceleration of %1").arg(parts[1]);
  if (parts[2].startsWith("max_jerk")) return QCoreApplication::translate("ParameterNames", "Jerk of %1").arg(parts[1]);
  if (parts[2].startsWith("travel")) return QCoreApplication::translate("ParameterNames", "Travel of %1").arg(parts[1]);
  if (parts[2].startsWith("steps")) return QCoreApplication::translate("ParameterNames", "Steps of %1").arg(parts[1]);
  return QString::fromStdString(key);
}

}  // namespace toolpace::ui
