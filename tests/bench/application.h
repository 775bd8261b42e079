#pragma once
/// What widgets need.

#include <QApplication>

namespace toolpace::bench {

/// Made at the first call; lives as long as the program.
QApplication& application();

}  // namespace toolpace::bench
