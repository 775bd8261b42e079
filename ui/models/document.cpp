#include "models/document.h"

namespace toolpace::ui {

QString Document::shown_line(const ProgramText& text, qsizetype number) {
  constexpr qsizetype kLongest = 4096;  // nobody reads on, and drawing must stay quick
  return text.line(number, kLongest);
}

std::array<bool, 3> turned_axes(const Moves& moves) {
  std::array<bool, 3> turned = {};
  for (const auto& end : moves.end) {
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const auto axis = static_cast<Eigen::Index>(3 + i);
      turned[i] = turned[i] || end[axis] != moves.start[axis];
    }
  }
  return turned;
}

}  // namespace toolpace::ui
