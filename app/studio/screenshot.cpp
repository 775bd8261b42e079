#include "screenshot.h"

#include <QApplication>

#include "end_on_signals.h"
#include "main_window.h"
#include "theme/finish_drawing.h"
#include "toolpace/base/monitor.h"

namespace toolpace::studio {
namespace {

/// Whatever changes does so in this thread's events.
template <class Done>
void wait_until(const Done& done) {
  while (!done() && !is_ended()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

}  // namespace

void settle(MainWindow& window) {
  do {
    wait_until([&window] { return window.isAtRest(); });
    ui::finish_drawing();
  } while (!window.isAtRest() && !is_ended());
}

void settle_with_proof(MainWindow& window) {
  settle(window);
  wait_until([&window] { return !window.workspace().isProving(); });
  settle(window);
}

Result<void> take_screenshot(MainWindow& window, const QString& file) {
  settle_with_proof(window);
  if (is_ended()) return tl::unexpected(cancelled_error());
  return window.savePicture(MainWindow::Picture::window, file);
}

}  // namespace toolpace::studio
