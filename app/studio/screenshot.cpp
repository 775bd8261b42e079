#include "screenshot.h"

#include <QApplication>
#include <QEventLoop>
#include <QPixmap>
#include <QTimer>

#include "end_on_signals.h"
#include "main_window.h"
#include "theme/picture_file.h"
#include "toolpace/base/monitor.h"

namespace toolpace::studio {
namespace {

constexpr int kPaintMs = 250;  // for pictures that are refined at rest

template <class Done>
void wait_until(const Done& done) {
  while (!done() && !is_ended()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

}  // namespace

void settle(MainWindow& window) {
  wait_until([&window] { return window.isSettled(); });
  QEventLoop loop;
  QTimer::singleShot(kPaintMs, &loop, &QEventLoop::quit);
  loop.exec();
}

Result<void> take_screenshot(MainWindow& window, const QString& file) {
  settle(window);
  wait_until([&window] { return !window.workspace().isProving(); });
  QApplication::processEvents();
  if (is_ended()) return tl::unexpected(cancelled_error());
  return ui::save_picture(file, {window.size(), [&window] { return window.grab().toImage(); }});
}

}  // namespace toolpace::studio
