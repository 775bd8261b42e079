#include "preferences.h"

#include <QSettings>

#include "toolpace/nc/dialect.h"

namespace toolpace::studio {
namespace {

constexpr int kLayoutVersion = 2;  // an older layout does not fit the panels
constexpr qsizetype kRecent = 10;

QSettings settings() { return QSettings(QSettings::IniFormat, QSettings::UserScope, "toolpace", "studio"); }

ReadOptions load_reading(const QSettings& s) {
  ReadOptions options;
  const std::string dialect = s.value("reading/dialect").toString().toStdString();
  if (const auto named = dialect_named(dialect)) options.dialect = *named;
  const int integers = s.value("reading/integers", 0).toInt();
  if (integers >= 0 && integers <= static_cast<int>(IntegerWords::increments))
    options.integers = static_cast<IntegerWords>(integers);
  options.strict = s.value("reading/strict", false).toBool();
  options.block_delete = s.value("reading/block_delete", false).toBool();
  options.tools = s.value("reading/tools").toString().toStdString();
  options.parameters = s.value("reading/parameters").toString().toStdString();
  for (const QString& folder : s.value("reading/folders").toStringList()) {
    options.sub_paths.push_back(folder.toStdString());
  }
  bool fine = false;
  const double arc = s.value("reading/arc_tolerance_mm").toDouble(&fine);
  if (fine && arc > 0) options.arc_tolerance = arc;
  return options;
}

void save_reading(QSettings& s, const ReadOptions& options) {
  const std::string_view dialect = dialect_name(options.dialect);
  s.setValue("reading/dialect", QString::fromUtf8(dialect.data(), static_cast<qsizetype>(dialect.size())));
  s.setValue("reading/integers", static_cast<int>(options.integers));
  s.setValue("reading/strict", options.strict);
  s.setValue("reading/block_delete", options.block_delete);
  s.setValue("reading/tools", QString::fromStdString(options.tools.string()));
  s.setValue("reading/parameters", QString::fromStdString(options.parameters.string()));
  QStringList folders;
  for (const auto& folder : options.sub_paths) folders << QString::fromStdString(folder.string());
  s.setValue("reading/folders", folders);
  if (options.arc_tolerance) {
    s.setValue("reading/arc_tolerance_mm", *options.arc_tolerance);
  } else {
    s.remove("reading/arc_tolerance_mm");
  }
}

}  // namespace

Preferences load_preferences() {
  const QSettings s = settings();
  Preferences p;
  p.dark = s.value("window/dark", false).toBool();
  p.touch = s.value("window/touch", false).toBool();
  p.units = {s.value("window/inch", false).toBool(), s.value("window/per_minute", false).toBool()};
  p.line_times = s.value("window/line_times", true).toBool();
  p.rapids = s.value("window/rapids", true).toBool();
  p.welcomed = s.value("window/welcomed", false).toBool();
  p.language = s.value("window/language").toString();
  p.colour_map = s.value("window/colour_map", "cividis").toString();
  p.reading = load_reading(s);
  if (const double baud = s.value("controller/baud").toDouble(); baud > 0) p.supply.baud = baud;
  if (const double time = s.value("controller/block_time_s").toDouble(); time > 0) p.supply.block_time = time;
  p.timer_hz = s.value("export/timer_hz", p.timer_hz).toDouble();
  p.axis_derivatives = s.value("export/axis_derivatives", false).toBool();
  p.decimal_comma = s.value("export/decimal_comma", false).toBool();
  if (s.value("window/layout_version").toInt() == kLayoutVersion) {
    p.geometry = s.value("window/geometry").toByteArray();
    p.layout = s.value("window/layout").toByteArray();
  }
  p.recent_programs = s.value("recent/programs").toStringList();
  p.recent_machines = s.value("recent/machines").toStringList();
  p.recent_controllers = s.value("recent/controllers").toStringList();
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
  s.setValue("window/line_times", p.line_times);
  s.setValue("window/rapids", p.rapids);
  s.setValue("window/welcomed", p.welcomed);
  s.setValue("window/language", p.language);
  s.setValue("window/colour_map", p.colour_map);
  save_reading(s, p.reading);
  s.setValue("controller/baud", p.supply.baud.value_or(0.0));
  s.setValue("controller/block_time_s", p.supply.block_time.value_or(0.0));
  s.setValue("export/timer_hz", p.timer_hz);
  s.setValue("export/axis_derivatives", p.axis_derivatives);
  s.setValue("export/decimal_comma", p.decimal_comma);
  s.setValue("window/layout_version", kLayoutVersion);
  s.setValue("window/geometry", p.geometry);
  s.setValue("window/layout", p.layout);
  s.setValue("recent/programs", p.recent_programs);
  s.setValue("recent/machines", p.recent_machines);
  s.setValue("recent/controllers", p.recent_controllers);
  s.setValue("recent/last_program", p.last_program);
  s.setValue("recent/last_machine", p.last_machine);
}

void remember(QStringList& recent, const QString& path) {
  recent.removeAll(path);
  recent.prepend(path);
  while (recent.size() > kRecent) recent.removeLast();
}

}  // namespace toolpace::studio
