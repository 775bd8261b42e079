#include "models/controller_names.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "models/units.h"
#include "toolpace/base/axes.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastStarved = 5e-4;  // [s]; less is nothing to a person

// Listed for the translators; looked up by the title itself, without the axis before it.
constexpr std::array kTitles = {QT_TRANSLATE_NOOP("ControllerNames", "step idle delay"),
                                QT_TRANSLATE_NOOP("ControllerNames", "junction deviation"),
                                QT_TRANSLATE_NOOP("ControllerNames", "arc tolerance"),
                                QT_TRANSLATE_NOOP("ControllerNames", "laser mode"),
                                QT_TRANSLATE_NOOP("ControllerNames", "steps"),
                                QT_TRANSLATE_NOOP("ControllerNames", "rate"),
                                QT_TRANSLATE_NOOP("ControllerNames", "acceleration"),
                                QT_TRANSLATE_NOOP("ControllerNames", "planner buffer"),
                                QT_TRANSLATE_NOOP("ControllerNames", "speed"),
                                QT_TRANSLATE_NOOP("ControllerNames", "square corner velocity"),
                                QT_TRANSLATE_NOOP("ControllerNames", "minimum cruise ratio"),
                                QT_TRANSLATE_NOOP("ControllerNames", "arc resolution"),
                                QT_TRANSLATE_NOOP("ControllerNames", "nozzle"),
                                QT_TRANSLATE_NOOP("ControllerNames", "filament"),
                                QT_TRANSLATE_NOOP("ControllerNames", "speed of the extruder alone"),
                                QT_TRANSLATE_NOOP("ControllerNames", "acceleration of the extruder alone"),
                                QT_TRANSLATE_NOOP("ControllerNames", "extruder's step of speed at corners"),
                                QT_TRANSLATE_NOOP("ControllerNames", "feedrate"),
                                QT_TRANSLATE_NOOP("ControllerNames", "printing acceleration"),
                                QT_TRANSLATE_NOOP("ControllerNames", "travel acceleration"),
                                QT_TRANSLATE_NOOP("ControllerNames", "minimum feedrate"),
                                QT_TRANSLATE_NOOP("ControllerNames", "minimum travel feedrate"),
                                QT_TRANSLATE_NOOP("ControllerNames", "path velocity"),
                                QT_TRANSLATE_NOOP("ControllerNames", "look-ahead"),
                                QT_TRANSLATE_NOOP("ControllerNames", "arc blends"),
                                QT_TRANSLATE_NOOP("ControllerNames", "kink that passes as tangent"),
                                QT_TRANSLATE_NOOP("ControllerNames", "most feed override"),
                                QT_TRANSLATE_NOOP("ControllerNames", "least length of a blend"),
                                QT_TRANSLATE_NOOP("ControllerNames", "ramp frequency"),
                                QT_TRANSLATE_NOOP("ControllerNames", "cycle of the interpreter"),
                                QT_TRANSLATE_NOOP("ControllerNames", "servo period"),
                                QT_TRANSLATE_NOOP("ControllerNames", "blend tolerance"),
                                QT_TRANSLATE_NOOP("ControllerNames", "velocity")};

constexpr std::array<const char*, kTimeLimitCount> kLimits = {QT_TRANSLATE_NOOP("ControllerNames", "programmed feed"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "rapid"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "speed of the axes"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "acceleration"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "corners"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "look-ahead"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "link"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "stops"),
                                                              QT_TRANSLATE_NOOP("ControllerNames", "dwell")};

QString words(const char* text) { return QCoreApplication::translate("ControllerNames", text); }

}  // namespace

QString setting_title(const std::string& title) {
  const bool has_axis = title.size() > 2 && title[1] == ' ' &&
                        std::find(kAxisNames.begin(), kAxisNames.end(), title[0]) != kAxisNames.end();
  const QString rest = QString::fromStdString(has_axis ? title.substr(2) : title);
  const auto known =
      std::find_if(kTitles.begin(), kTitles.end(), [&](const char* t) { return rest == QLatin1String(t); });
  const QString name = known == kTitles.end() ? rest : words(*known);
  return has_axis ? QString(QLatin1Char(title[0])) + ' ' + name : name;
}

QString setting_name(const std::string& key, const std::string& title) {
  const QString shown = QString::fromStdString(key);
  return key.starts_with('[') ? shown : shown + "  " + setting_title(title);
}

QString setting_unit(const std::string& unit) {
  if (unit == "1") return {};
  if (unit == "blocks") return QCoreApplication::translate("ControllerNames", "blocks");
  if (unit == "cycles") return QCoreApplication::translate("ControllerNames", "cycles");
  return QString::fromStdString(unit);
}

QString time_limit_title(TimeLimit limit) { return words(kLimits[static_cast<std::size_t>(limit)]); }

QString controller_verdict(const Prediction& prediction, std::optional<double> as_setpoints) {
  const auto title = controller_title(prediction.controller);
  const QString name = QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()));
  QString there =
      QCoreApplication::translate("ControllerNames", "On %1 %2").arg(name, duration_text(prediction.cycle_time));
  if (prediction.starved >= kLeastStarved)
    there += QCoreApplication::translate("ControllerNames", ", %1 of it for blocks that have not come")
                 .arg(duration_text(prediction.starved));
  if (!as_setpoints) return there;
  return there + QCoreApplication::translate("ControllerNames", "; as setpoints %1").arg(duration_text(*as_setpoints));
}

}  // namespace toolpace::ui
