#pragma once
/// A picture of the window, taken once everything it shows is there.

#include <QString>

#include "toolpace/base/result.h"

namespace toolpace::studio {

class MainWindow;

/// Waits until the program is open (or refused), planned and proven, then saves the window as PNG. Errors: those of
/// savePicture, and cancelled when a signal came.
Result<void> take_screenshot(MainWindow& window, const QString& file);

/// Runs the event loop until reading and planning are done and the window is laid out and drawn as it stays, or a signal
/// ends the process.
void settle(MainWindow& window);

/// And until the setpoints are proven and the drives simulated.
void settle_with_proof(MainWindow& window);

}  // namespace toolpace::studio
