#include "models/document.h"

#include <QStringDecoder>
#include <algorithm>

namespace toolpace::ui {

QString Document::line(qsizetype number) const {
  if (number < 1 || number > line_count()) return {};
  const qsizetype begin = line_starts[static_cast<std::size_t>(number - 1)];
  qsizetype end = number == line_count() ? text.size() : line_starts[static_cast<std::size_t>(number)];
  while (end > begin && (text[end - 1] == '\n' || text[end - 1] == '\r')) --end;
  constexpr qsizetype kLongest = 4096;  // nobody reads on, and drawing must stay quick
  const QByteArray bytes = text.mid(begin, std::min(end - begin, kLongest));
  QStringDecoder decoder(QStringDecoder::Utf8);
  const QString decoded = decoder(bytes);
  return decoder.hasError() ? QString::fromLatin1(bytes) : decoded;
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

std::vector<qsizetype> find_line_starts(const QByteArray& text) {
  std::vector<qsizetype> starts{0};
  starts.reserve(static_cast<std::size_t>(text.count('\n')) + 1);
  for (qsizetype at = text.indexOf('\n'); at >= 0; at = text.indexOf('\n', at + 1)) {
    if (at + 1 < text.size()) starts.push_back(at + 1);
  }
  return starts;
}

}  // namespace toolpace::ui
