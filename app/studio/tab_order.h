#pragma once
/// Tab follows the eye: from panel to panel and, in each of them, row by row, wherever the panels are.

#include <QMainWindow>
#include <vector>

namespace toolpace::studio {

/// What Tab goes through, in the order in which it is read; only what is visible and can be used.
std::vector<QWidget*> reading_order(const QMainWindow& window);

/// Puts the focus on the next one, or the one before, and into sight. False: there is none.
bool focus_next(QMainWindow& window, bool next);

}  // namespace toolpace::studio
