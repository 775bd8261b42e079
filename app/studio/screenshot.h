#pragma once
/// A picture of the window, taken once everything it shows is there.

#include <QString>

namespace toolpace::studio {

class MainWindow;

/// Waits until the program is open (or refused) and planned, then saves the window as PNG (the extension decides).
/// False, with a message on stderr, where the file cannot be written.
bool take_screenshot(MainWindow& window, const QString& file);

/// Runs the event loop until reading and planning are done and the picture has been drawn.
void settle(MainWindow& window);

}  // namespace toolpace::studio
