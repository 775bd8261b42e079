#pragma once
/// Files that a test writes and looks at; what goes wrong with one ends the test.

#include <QByteArray>
#include <QString>

namespace toolpace::ui {

/// A program: once around 10 mm by 10 mm.
inline constexpr auto kSquare = "G21 G90 G94\nG1 F1200 X10\nY10\nX0\nY0\nM2\n";

void write(const QString& path, const QByteArray& text);

QByteArray content(const QString& path);

}  // namespace toolpace::ui
