#pragma once
/// The program in the window: its text, line by line, and what was read from it. Immutable; a change makes a new one.

#include <QByteArray>
#include <QString>
#include <array>
#include <memory>
#include <vector>

#include "toolpace/nc/reader.h"

namespace toolpace::ui {

struct Document {
  QString path;  ///< file it came from; empty for the built-in example
  QString name;  ///< shown to people
  QByteArray text;
  std::vector<qsizetype> line_starts;  ///< byte offset of each line; at least one entry
  std::shared_ptr<const Reading> reading;
  std::array<bool, 3> turned = {};  ///< which of A, B, C the program moves

  qsizetype line_count() const { return static_cast<qsizetype>(line_starts.size()); }
  /// Text of a line, counted from 1, without its line end; UTF-8, or Latin-1 where it is not valid UTF-8.
  QString line(qsizetype number) const;
};

/// Which of A, B, C move; made by a worker, as programs are long.
std::array<bool, 3> turned_axes(const Moves& moves);

/// Finds the line starts ("\n", "\r\n"). A text that ends in a line end has no extra empty line after it.
std::vector<qsizetype> find_line_starts(const QByteArray& text);

}  // namespace toolpace::ui
