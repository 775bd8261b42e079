/// toolpace-studio: the workbench.

#include <QApplication>
#include <QFile>
#include <QIcon>
#include <cstdio>
#include <optional>

#include "command_line.h"
#include "end_on_signals.h"
#include "main_window.h"
#include "memory_policy.h"
#include "screenshot.h"
#include "version.h"

namespace {

using namespace toolpace::studio;

QStringList arguments_of(int argc, char** argv) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QFile::decodeName(argv[i]);
  return arguments;
}

/// A picture needs no display.
void draw_without_display() {
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
      qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
}

int run(QApplication& application, const Request& request) {
  const bool picture = !request.screenshot.isEmpty();
  MainWindow window(!picture);
  end_on_signals(&window);
  if (request.size) window.resize(*request.size);
  if (!request.language.isEmpty()) window.setLanguage(request.language);
  if (!request.theme.isEmpty()) window.setDark(request.theme == "dark");
  if (request.touch) window.setTouch(true);
  if (request.inch) window.setInch(true);
  if (request.per_minute) window.setPerMinute(true);
  std::optional<toolpace::Error> failure;
  QObject::connect(&window, &MainWindow::failed, [&failure](const toolpace::Error& error) { failure = error; });
  if (!request.machine.isEmpty() && !window.openMachine(request.machine)) return report(*failure);
  if (!request.controller.isEmpty() && !window.openController(request.controller)) return report(*failure);
  window.show();
  if (request.program.isEmpty()) {
    picture ? window.openExample() : window.openLast();
  } else {
    window.openProgram(request.program);
  }
  if (!picture) return application.exec();
  settle(window);
  // What is wrong inside a program is in the picture; of what could not even be opened there is none.
  const bool is_in_picture = failure && failure->kind != toolpace::ErrorKind::io;
  if (failure && !is_in_picture) return report(*failure);
  if (const auto taken = take_screenshot(window, request.screenshot); !taken) return report(taken.error());
  return kFine;
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory_between_plans();
  QCoreApplication::setApplicationName("toolpace-studio");
  QCoreApplication::setApplicationVersion(toolpace::version());
  const auto request = parse_command_line(arguments_of(argc, argv));
  if (!request) return report(request.error());
  if (!request->answer.isEmpty()) return std::fputs(qPrintable(request->answer), stdout) < 0 ? kFileTrouble : kFine;
  if (!request->screenshot.isEmpty()) draw_without_display();
  QApplication application(argc, argv);
  QApplication::setApplicationDisplayName("Toolpace");
  QApplication::setDesktopFileName("io.github.toolpace.Toolpace");
  QApplication::setWindowIcon(QIcon(":/icons/toolpace.svg"));
  return run(application, *request);
}
