#include "screenshot.h"

#include <QApplication>
#include <QEventLoop>
#include <QPixmap>
#include <QTimer>
#include <cstdio>

#include "main_window.h"

namespace toolpace::studio {
namespace {

constexpr int kPaintMs = 250;  // for pictures that are refined at rest

}  // namespace

void settle(MainWindow& window) {
  QEventLoop loop;
  QObject::connect(&window.workspace(), &ui::Workspace::busyChanged, &loop, [&](bool busy) {
    if (!busy) loop.quit();
  });
  while (!window.isSettled()) loop.exec();
  QTimer::singleShot(kPaintMs, &loop, &QEventLoop::quit);
  loop.exec();
}

bool take_screenshot(MainWindow& window, const QString& file) {
  settle(window);
  while (window.workspace().isProving()) QApplication::processEvents(QEventLoop::WaitForMoreEvents, kPaintMs);
  QApplication::processEvents();
  if (window.grab().save(file)) return true;
  std::fprintf(stderr, "toolpace-studio: error: %s: cannot be written\n", qPrintable(file));
  return false;
}

}  // namespace toolpace::studio
