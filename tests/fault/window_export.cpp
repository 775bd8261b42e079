/// What the window writes, as a command, so that faults can strike it: window_export WHAT PROGRAM MACHINE TARGET opens both,
/// writes the target once everything is at rest, and ends with the exit codes of the command line.

#include <QApplication>
#include <cstdio>
#include <map>
#include <string>

#include "end_on_signals.h"
#include "main_window.h"
#include "screenshot.h"
#include "toolpace/base/error_text.h"

using namespace toolpace;
using namespace toolpace::studio;

namespace {

constexpr int kFine = 0, kBadUsage = 2, kBadInput = 3, kFileTrouble = 4;

/// What to write, by name.
const std::map<std::string, void (*)(MainWindow&, const QString&)> kExports = {
    {"setpoints", [](MainWindow& w, const QString& file) { w.saveSetpoints(file); }},
    {"contour", [](MainWindow& w, const QString& file) { (void)w.savePicture(MainWindow::Picture::contour, file); }},
    {"plots", [](MainWindow& w, const QString& file) { (void)w.savePicture(MainWindow::Picture::plots, file); }},
    {"window", [](MainWindow& w, const QString& file) { (void)w.savePicture(MainWindow::Picture::window, file); }},
    {"report", [](MainWindow& w, const QString& file) { w.saveReport(file); }},
    {"program", [](MainWindow& w, const QString& file) { w.storeProgramAs(file); }},
    {"machine", [](MainWindow& w, const QString& file) { w.storeMachineAs(file); }},
};

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const auto what = argc == 5 ? kExports.find(argv[1]) : kExports.end();
  if (what == kExports.end()) return kBadUsage;
  MainWindow window(false);
  end_on_signals(&window);
  int code = kFine;
  QObject::connect(&window, &MainWindow::failed, [&code](const Error& error) {
    std::fputs(error_text(error).c_str(), stderr);
    code = error.kind == ErrorKind::io ? kFileTrouble : kBadInput;
  });
  window.setLanguage("en");
  if (!window.openMachine(argv[3])) return code;
  window.show();
  window.openProgram(argv[2]);
  settle(window);
  if (code != kFine) return code;
  what->second(window, argv[4]);
  settle(window);
  return code;
}
