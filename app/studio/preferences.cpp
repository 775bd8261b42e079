#include "preferences.h"

#include <QSettings>

namespace toolpace::studio {
namespace {

constexpr int kLayoutVersion = 2;  // an older layout does not fit the panels
constexpr qsizetype kRecent = 10;

QSettings settings() { return QSettings(QSettings::IniFormat, QSettings::UserScope, "toolpace", "studio"); }

}  // namespace

Preferences load_preferences() {
  const QSettings s = settings();
  Preferences p;
  p.dark = s.value("window/dark", false).toBool();
  p.touch = s.value("window/touch", false).toBool();
  p.units = {s.value("window/inch", false).toBool(), s.value("window/per_minute", false).toBool()};
  p.rapids = s.value("window/rapids", true).toBool();
  p.welcomed = s.value("window/welcomed", false).toBool();
  p.language = s.value("window/language").toString();
  p.colour_map = s.value("window/colour_map", "cividis").toString();
  p.timer_hz = s.value("export/timer_hz", p.timer_hz).toDouble();
  p.axis_derivatives = s.value("export/axis_derivatives", false).toBool();
  p.decimal_comma = s.value("export/decimal_comma", false).toBool();
  if (s.value("window/layout_version").toInt() == kLayoutVersion) {
    p.geometry = s.value("window/geometry").toByteArray();
    p.layout = s.value("window/layout").toByteArray();
  }
  p.recent_programs = s.value("recent/programs").toStringList();
  p.recent_machines = s.value("recent/machines").toStringList();
  p.last_program = s.value("recent/last_program").toString();
  p.last_machine = s.value("recent/last_machine").toString();
  return p;
}

void save_preferences(const Preferences& p) {
  QSettings s = settings();
  s.setValue("window/dark", p.dark);
  s.setValue("window/touch", p.touch);
  s.setValue("window/inch", p.units.inch);
  s.setValue("window/per_minute", p.units.per_minute);
  s.setValue("window/rapids", p.rapids);
  s.setValue("window/welcomed", p.welcomed);
  s.setValue("window/language", p.language);
  s.setValue("window/colour_map", p.colour_map);
  s.setValue("export/timer_hz", p.timer_hz);
  s.setValue("export/axis_derivatives", p.axis_derivatives);
  s.setValue("export/decimal_comma", p.decimal_comma);
  s.setValue("window/layout_version", kLayoutVersion);
  s.setValue("window/geometry", p.geometry);
  s.setValue("window/layout", p.layout);
  s.setValue("recent/programs", p.recent_programs);
  s.setValue("recent/machines", p.recent_machines);
  s.setValue("recent/last_program", p.last_program);
  s.setValue("recent/last_machine", p.last_machine);
}

void remember(QStringList& recent, const QString& path) {
  recent.removeAll(path);
  recent.prepend(path);
  while (recent.size() > kRecent) recent.removeLast();
}

}  // namespace toolpace::studio
