#include "panels/nc_syntax.h"

namespace toolpace::ui {
namespace {

qsizetype end_of_quiet(const QString& line, qsizetype at) {
  const QChar c = line[at];
  if (c == ';') return line.size();
  if (c == '(') {
    const qsizetype close = line.indexOf(')', at);
    return close < 0 ? line.size() : close + 1;
  }
  if (c == '%' || (c == '/' && line.left(at).trimmed().isEmpty())) return at + 1;
  const bool starts_number = (c == 'N' || c == 'n') && line.left(at).trimmed().isEmpty();
  if (!starts_number) return at;
  qsizetype end = at + 1;
  while (end < line.size() && (line[end].isDigit() || line[end] == '.')) ++end;
  return end > at + 1 ? end : at;
}

}  // namespace

std::vector<NcSpan> nc_spans(const QString& line) {
  std::vector<NcSpan> spans;
  qsizetype code = 0;
  qsizetype at = 0;
  while (at < line.size()) {
    const qsizetype end = end_of_quiet(line, at);
    if (end == at) {
      ++at;
      continue;
    }
    if (at > code) spans.push_back({code, at - code, NcSpanKind::code});
    spans.push_back({at, end - at, NcSpanKind::quiet});
    code = at = end;
  }
  if (line.size() > code) spans.push_back({code, line.size() - code, NcSpanKind::code});
  return spans;
}

}  // namespace toolpace::ui
