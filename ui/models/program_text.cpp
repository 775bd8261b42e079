#include "models/program_text.h"

#include <QStringDecoder>
#include <QStringEncoder>
#include <algorithm>

namespace toolpace::ui {
namespace {

constexpr QByteArrayView kUtf8Mark = "\xEF\xBB\xBF";

std::vector<qsizetype> find_line_starts(const QByteArray& text) {
  const char end = text.contains('\n') ? '\n' : '\r';  // old Macintosh files have the latter alone
  std::vector<qsizetype> starts{text.startsWith(kUtf8Mark) ? kUtf8Mark.size() : 0};
  starts.reserve(static_cast<std::size_t>(text.count(end)) + 1);
  for (qsizetype at = text.indexOf(end); at >= 0; at = text.indexOf(end, at + 1)) {
    if (at + 1 < text.size()) starts.push_back(at + 1);
  }
  return starts;
}

qsizetype length_without_end(QByteArrayView line) {
  qsizetype length = line.size();
  while (length > 0 && (line[length - 1] == '\n' || line[length - 1] == '\r')) --length;
  return length;
}

QString decoded(QByteArrayView bytes) {
  QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::ConvertInitialBom);
  const QString text = decoder(bytes);
  return decoder.hasError() ? QString::fromLatin1(bytes) : text;
}

ProgramText::Piece written(QByteArray line) { return {0, 1, -1, std::move(line)}; }

}  // namespace

ProgramText::ProgramText(QByteArray bytes) {
  auto base = std::make_shared<Base>();
  base->starts = find_line_starts(bytes);
  base->utf8 = bytes.isValidUtf8();
  base->bytes = std::move(bytes);
  pieces_ = {{0, static_cast<qsizetype>(base->starts.size()), 0, {}}};
  base_ = std::move(base);
}

QByteArrayView ProgramText::mark() const { return QByteArrayView(base_->bytes).first(base_->starts.front()); }

qsizetype ProgramText::size() const {
  qsizetype sum = mark().size();
  for (const Piece& piece : pieces_) sum += bytes_of(piece).size();
  return sum;
}

QByteArrayView ProgramText::base_lines(qsizetype first, qsizetype count) const {
  const auto& starts = base_->starts;
  const qsizetype begin = starts[static_cast<std::size_t>(first)];
  const auto last = static_cast<std::size_t>(first + count);
  const qsizetype end = last < starts.size() ? starts[last] : base_->bytes.size();
  return QByteArrayView(base_->bytes).sliced(begin, end - begin);
}

QByteArrayView ProgramText::bytes_of(const Piece& piece) const {
  return piece.base < 0 ? QByteArrayView(piece.written) : base_lines(piece.base, piece.count);
}

std::size_t ProgramText::piece_at(qsizetype index) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), index,
                                      [](qsizetype i, const Piece& piece) { return i < piece.begin; });
  return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

QByteArrayView ProgramText::raw_line(qsizetype number) const {
  const Piece& piece = pieces_[piece_at(number - 1)];
  return piece.base < 0 ? QByteArrayView(piece.written) : base_lines(piece.base + number - 1 - piece.begin, 1);
}

QString ProgramText::line(qsizetype number, qsizetype most_bytes) const {
  if (number < 1 || number > line_count()) return {};
  const QByteArrayView raw = raw_line(number);
  const qsizetype length = length_without_end(raw);
  return decoded(raw.first(most_bytes < 0 ? length : std::min(length, most_bytes)));
}

void ProgramText::for_each_piece(const std::function<bool(std::string_view)>& take) const {
  const auto give = [&take](QByteArrayView bytes) {
    return take({bytes.data(), static_cast<std::size_t>(bytes.size())});
  };
  if (!give(mark())) return;
  for (const Piece& piece : pieces_) {
    if (!give(bytes_of(piece))) return;
  }
}

QByteArray ProgramText::bytes() const {
  if (pieces_.size() == 1 && pieces_[0].count == static_cast<qsizetype>(base_->starts.size()) && pieces_[0].base == 0) {
    return base_->bytes;
  }
  QByteArray all;
  all.reserve(size());
  all += mark();
  for (const Piece& piece : pieces_) all += bytes_of(piece);
  return all;
}

QByteArray ProgramText::line_end(qsizetype number) const {
  for (const qsizetype candidate : {number, qsizetype{1}}) {
    const QByteArrayView raw = raw_line(candidate);
    const QByteArrayView end = raw.sliced(length_without_end(raw));
    if (!end.isEmpty()) return end.toByteArray();
  }
  return "\n";
}

// As the rest of the file is encoded, where that can be read back.
QByteArray ProgramText::encoded(const QString& text) const {
  QStringEncoder latin1(QStringEncoder::Latin1);
  const QByteArray bytes = latin1(text);
  return base_->utf8 || latin1.hasError() || decoded(bytes) != text ? text.toUtf8() : bytes;
}

ProgramText::Splice ProgramText::replacing(qsizetype number, const QString& text) const {
  QString line = text;
  line.replace('\n', ' ').replace('\r', ' ');
  const QByteArrayView raw = raw_line(number);
  return {number, 1, {written(encoded(line) + raw.sliced(length_without_end(raw)).toByteArray())}};
}

ProgramText::Splice ProgramText::inserting_after(qsizetype number) const {
  const QByteArray end = line_end(number);
  const QByteArrayView before = raw_line(number);
  if (length_without_end(before) < before.size()) return {number + 1, 0, {written(end)}};
  return {number, 1, {written(before.toByteArray() + end), written(end)}};  // the last line, which had no end so far
}

ProgramText::Splice ProgramText::removing(qsizetype first, qsizetype count) const {
  if (count < line_count()) return {first, count, {}};
  return {first, count, {written({})}};
}

std::size_t ProgramText::cut_before(qsizetype index) {
  if (index >= line_count()) return pieces_.size();
  const std::size_t at = piece_at(index);
  Piece& piece = pieces_[at];
  if (piece.begin == index) return at;
  Piece rest = piece;
  rest.begin = index;
  rest.count = piece.begin + piece.count - index;
  rest.base = piece.base + piece.count - rest.count;
  piece.count -= rest.count;
  pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::move(rest));
  return at + 1;
}

ProgramText::Splice ProgramText::apply(const Splice& splice) {
  const auto from = static_cast<std::ptrdiff_t>(cut_before(splice.first - 1));
  const auto to = static_cast<std::ptrdiff_t>(cut_before(splice.first - 1 + splice.count));
  Splice back{splice.first, 0, {pieces_.begin() + from, pieces_.begin() + to}};
  for (const Piece& piece : splice.lines) back.count += piece.count;
  pieces_.erase(pieces_.begin() + from, pieces_.begin() + to);
  pieces_.insert(pieces_.begin() + from, splice.lines.begin(), splice.lines.end());
  renumber();
  return back;
}

// Lines of the file that follow each other again become one piece again.
void ProgramText::renumber() {
  std::size_t kept = 0;
  qsizetype begin = 0;
  for (Piece& piece : pieces_) {
    piece.begin = begin;
    begin += piece.count;
    Piece* const before = kept > 0 ? &pieces_[kept - 1] : nullptr;
    if (before && before->base >= 0 && piece.base == before->base + before->count) {
      before->count += piece.count;
    } else if (Piece& place = pieces_[kept++]; &place != &piece) {
      place = std::move(piece);
    }
  }
  pieces_.resize(kept);
}

}  // namespace toolpace::ui
