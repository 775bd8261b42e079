#pragma once
/// The program in the window as it was read. Immutable; a change makes a new one.

#include <QString>
#include <array>
#include <memory>
#include <optional>

#include "models/program_text.h"
#include "toolpace/nc/reading.h"

namespace toolpace::ui {

struct Document {
  QString path;      ///< file it came from; empty for the built-in example
  QString name;      ///< shown to people; its extension chooses the format
  ProgramText text;  ///< that was read
  std::shared_ptr<const Reading> reading;
  std::array<bool, 3> turned = {};      ///< which of A, B, C the program moves
  std::optional<quint64> edited_state;  ///< of an edited text, its state (program_model.h); none: as the file has it

  qsizetype line_count() const { return text.line_count(); }
  /// Text of a line as it is shown; what is very long is cut off.
  QString line(qsizetype number) const { return shown_line(text, number); }
  static QString shown_line(const ProgramText& text, qsizetype number);
};

/// Which of A, B, C move; made by a worker, as programs are long.
std::array<bool, 3> turned_axes(const Moves& moves);

}  // namespace toolpace::ui
