/// toolpace-studio: the workbench.

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QTimer>
#include <cstdio>

#include "main_window.h"
#include "memory_policy.h"
#include "screenshot.h"

namespace {

enum ExitCode : int { kFine = 0, kBadUsage = 2, kFileTrouble = 4 };

struct Request {
  QString program, machine, screenshot, language, theme;
  QSize size = {1280, 800};
  bool touch = false, inch = false;
};

int complain(const QString& text) {
  std::fprintf(stderr, "toolpace-studio: error: %s\n", qPrintable(text));
  return kBadUsage;
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
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("PROGRAM", "NC program or CSV polyline to open", "[PROGRAM]");
  parser.addOptions({{"machine", "machine file (TOML)", "FILE"},
                     {"screenshot", "open, plan, draw, save the window's picture and leave", "OUT.png"},
                     {"size", "size of the window in pixels, such as 1280x800", "WxH"},
                     {"language", "en or zh_CN", "LANGUAGE"},
                     {"theme", "light or dark", "THEME"},
                     {"touch", "controls large enough for fingers"},
                     {"inch", "show inches"}});
}

int run(QApplication& application, const Request& request) {
  using namespace toolpace::studio;
  const bool picture = !request.screenshot.isEmpty();
  MainWindow window(!picture);
  window.resize(request.size);
  if (!request.language.isEmpty()) window.setLanguage(request.language);
  if (!request.theme.isEmpty()) window.setDark(request.theme == "dark");
  if (request.touch) window.setTouch(true);
  if (request.inch) window.setInch(true);
  if (!request.machine.isEmpty() && !window.openMachine(request.machine)) return kFileTrouble;
  window.show();
  if (request.program.isEmpty()) {
    picture ? window.openExample() : window.openLast();
  } else {
    window.openProgram(request.program);
  }
  if (picture) return take_screenshot(window, request.screenshot) ? kFine : kFileTrouble;
  return application.exec();
}

}  // namespace

int main(int argc, char** argv) {
  toolpace::studio::keep_memory_between_plans();
  QApplication application(argc, argv);
  QApplication::setApplicationName("toolpace-studio");
  QApplication::setApplicationDisplayName("Toolpace");
  QApplication::setApplicationVersion(TOOLPACE_VERSION);
  QApplication::setDesktopFileName("io.github.toolpace.Toolpace");
  QApplication::setWindowIcon(QIcon(":/icons/toolpace.svg"));
  QCommandLineParser parser;
  add_options(parser);
  parser.process(application);

  Request request;
  if (parser.positionalArguments().size() > 1) return complain("more than one program");
  if (!parser.positionalArguments().isEmpty()) {
    request.program = QFileInfo(parser.positionalArguments().constFirst()).absoluteFilePath();
  }
  request.machine = parser.value("machine");
  request.screenshot = parser.value("screenshot");
  request.language = parser.value("language");
  request.theme = parser.value("theme");
  request.touch = parser.isSet("touch");
  request.inch = parser.isSet("inch");
  if (parser.isSet("size")) {
    const auto size = parse_size(parser.value("size"));
    if (!size) return complain("--size wants WIDTHxHEIGHT, such as 1280x800");
    request.size = *size;
  }
  if (!request.language.isEmpty() && request.language != "en" && request.language != "zh_CN") {
    return complain("--language wants en or zh_CN");
  }
  if (!request.theme.isEmpty() && request.theme != "light" && request.theme != "dark") {
    return complain("--theme wants light or dark");
  }
  return run(application, request);
}
