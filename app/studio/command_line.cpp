#include "command_line.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "theme/picture_file.h"
#include "toolpace/base/error_text.h"
#include "version.h"

namespace toolpace::studio {
namespace {

constexpr std::array kQtOptions = {"platform",   "platformpluginpath", "platformtheme", "plugin",       "style",
                                   "stylesheet", "qwindowgeometry",    "qwindowicon",   "qwindowtitle", "session",
                                   "display",    "geometry",           "fontengine"};
constexpr std::array kQtFlags = {"reverse", "widgetcount"};

template <std::size_t N>
bool is_one_of(const QString& name, const std::array<const char*, N>& names) {
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == QLatin1String(n); });
}

/// Without those that QApplication takes away before anybody sees them.
QStringList without_qt_options(const QStringList& arguments) {
  QStringList rest;
  for (qsizetype i = 0; i < arguments.size(); ++i) {
    const QString& argument = arguments[i];
    if (i == 0 || !argument.startsWith('-')) {
      rest << argument;
      continue;
    }
    const QString name = argument.mid(argument.startsWith("--") ? 2 : 1);
    if (is_one_of(name, kQtOptions)) {
      ++i;  // and its value
    } else if (!is_one_of(name, kQtFlags) && !is_one_of(name.section('=', 0, 0), kQtOptions)) {
      rest << argument;
    }
  }
  return rest;
}

Error usage(const QString& what, const char* remedy = "toolpace-studio --help lists the options") {
  return {ErrorKind::usage, "usage", what.toStdString(), remedy, {}, {}};
}

std::optional<QSize> parse_size(const QString& text) {
  const QStringList parts = text.split('x');
  if (parts.size() != 2) return std::nullopt;
  bool wide = false, high = false;
  const QSize size(parts[0].toInt(&wide), parts[1].toInt(&high));
  constexpr int kMost = 16384;
  if (!wide || !high || size.width() < 1 || size.height() < 1 || size.width() > kMost || size.height() > kMost) {
    return std::nullopt;
  }
  return size;
}

void add_options(QCommandLineParser& parser) {
  parser.setApplicationDescription("Motion-planning workbench for CNC machines.");
  parser.addPositionalArgument("PROGRAM", "NC program or CSV polyline to open", "[PROGRAM]");
  parser.addOptions({{{"h", "help"}, "print this help and leave"},
                     {{"v", "version"}, "print the version and leave"},
                     {"machine", "machine file (TOML)", "FILE"},
                     {"controller", "settings file of a controller that the program runs on", "FILE"},
                     {"screenshot", "open, plan, draw, save the window's picture and leave", "OUT.png"},
                     {"size", "size of the window in pixels, such as 1280x800", "WxH"},
                     {"language", "en or zh_CN", "LANGUAGE"},
                     {"theme", "light or dark", "THEME"},
                     {"touch", "controls large enough for fingers"},
                     {"inch", "show inches"},
                     {"per-minute", "show speeds a minute instead of a second"}});
}

/// Qt's help wants an application, for its name alone; this kind needs no display.
QString help_of(const QCommandLineParser& parser) {
  int count = 1;
  std::string name = "toolpace-studio";
  char* arguments[] = {name.data(), nullptr};
  const QCoreApplication application(count, arguments);
  return parser.helpText();
}

Result<Request> read_options(const QCommandLineParser& parser) {
  Request request;
  const QStringList programs = parser.positionalArguments();
  if (programs.size() > 1) return tl::unexpected(usage("more than one program", "name one"));
  if (!programs.isEmpty()) request.program = QFileInfo(programs.constFirst()).absoluteFilePath();
  request.machine = parser.value("machine");
  request.controller = parser.value("controller");
  request.screenshot = parser.value("screenshot");
  request.language = parser.value("language");
  request.theme = parser.value("theme");
  request.touch = parser.isSet("touch");
  request.inch = parser.isSet("inch");
  request.per_minute = parser.isSet("per-minute");
  if (parser.isSet("size")) {
    const auto size = parse_size(parser.value("size"));
    if (!size) return tl::unexpected(usage("--size is no size", "give WIDTHxHEIGHT, such as 1280x800"));
    request.size = *size;
  }
  if (parser.isSet("language") && request.language != "en" && request.language != "zh_CN") {
    return tl::unexpected(usage("--language is unknown", "give en or zh_CN"));
  }
  if (parser.isSet("theme") && request.theme != "light" && request.theme != "dark") {
    return tl::unexpected(usage("--theme is unknown", "give light or dark"));
  }
  if (parser.isSet("screenshot")) {
    if (request.screenshot.isEmpty()) return tl::unexpected(usage("--screenshot names no file", "give OUT.png"));
    if (auto named = ui::check_picture_name(request.screenshot, false); !named) return tl::unexpected(named.error());
  }
  return request;
}

}  // namespace

Result<Request> parse_command_line(const QStringList& arguments) {
  QCommandLineParser parser;
  add_options(parser);
  if (!parser.parse(without_qt_options(arguments))) {
    QString what = parser.errorText();
    if (what.endsWith('.')) what.chop(1);
    return tl::unexpected(usage(what));
  }
  Request request;
  if (parser.isSet("help")) request.answer = help_of(parser);
  if (parser.isSet("version")) request.answer = QString("toolpace-studio %1\n").arg(toolpace::version());
  return request.answer.isEmpty() ? read_options(parser) : request;
}

ExitCode report(const Error& error) {
  std::fputs(error_text(error).c_str(), stderr);
  switch (error.kind) {
    case ErrorKind::usage: return kBadUsage;
    case ErrorKind::input:
    case ErrorKind::infeasible: return kBadInput;
    case ErrorKind::io: return kFileTrouble;
    case ErrorKind::cancelled: return kInterrupted;
  }
  return kBadInput;
}

}  // namespace toolpace::studio
