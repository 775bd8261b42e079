#pragma once
/// Whether what stands in a window can be read.

#include <QAbstractButton>
#include <QStringList>
#include <QWidget>

namespace toolpace::ui {

/// Whether it has a text to read, and not an icon alone.
bool shows_text(const QAbstractButton& button);

/// What a person would stumble over: texts of labels, buttons and fields that stand out too little from their ground (below 4.5, as
/// the web's guidelines ask), and controls that lie over each other.
QStringList illegible_in(QWidget& window);

}  // namespace toolpace::ui
