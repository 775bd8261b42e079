#pragma once
/// The lines between the rows of a program, in the order in which a controller reads them.

#include "toolpace/controller/program_text.h"
#include "toolpace/nc/reading.h"

namespace toolpace::detail::controller {

/// Tells a model, before each row, which lines come first.
class RowWalk {
 public:
  RowWalk(const Reading& reading, const ProgramText& text) : moves_(reading.moves), text_(text) {}

  /// Calls take(line) for the lines up to that of the row which were not told yet. A line that a loop runs again is told again.
  template <class Take>
  void advance_to(std::size_t row, const Take& take) {
    if (moves_.file[row] != 0) return;
    const std::size_t line = moves_.line[row];
    if (line < last_) last_ = line == 0 ? 0 : line - 1;
    for (; last_ < line; ++last_) take(last_ + 1);
  }

  /// The same for the lines behind the last row.
  template <class Take>
  void advance_to_end(const Take& take) {
    for (; last_ < text_.lines(); ++last_) take(last_ + 1);
  }

  /// The bits of a line.
  std::uint8_t codes(std::size_t line) const { return line <= text_.lines() ? text_.codes[line - 1] : std::uint8_t{0}; }
  std::size_t bytes(std::size_t line) const { return line <= text_.lines() ? text_.bytes[line - 1] : 0u; }

 private:
  const Moves& moves_;
  const ProgramText& text_;
  std::size_t last_ = 0;
};

/// F as it holds for G0 and G1 alike, as printers have it [mm/s]; `first` before the first one.
inline double printer_speed(const Reading& reading, std::size_t row, double first) {
  const Moves& moves = reading.moves;
  if (moves.kind[row] != MoveKind::rapid) return moves.feed[row];
  const auto modal = reading.modal.at(moves.line[row], moves.file[row]);
  if (!modal || !(modal->feed > 0)) return first;
  constexpr double kMmPerInch = 25.4;
  return modal->feed * (modal->units == 200 ? kMmPerInch : 1.0) * kPerMinute;
}

}  // namespace toolpace::detail::controller
