#pragma once
/// The text of a program, line by line: as it stands in its file, with what was written into it since.

#include <QByteArray>
#include <QByteArrayView>
#include <QString>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace toolpace::ui {

/// A value whose copies share the text of the file, so that an edit of a program of a million lines costs a few bytes.
/// What nobody edits keeps its bytes: line ends ("\n", "\r\n", or "\r" where nothing else stands), encoding, a mark of
/// UTF-8 at the beginning, a last line without an end. Lines count from 1. A text that ends in a line end has no extra
/// empty line after it; an empty text is one empty line.
class ProgramText {
 public:
  /// Lines that follow each other: of the file, or one that was written here.
  struct Piece {
    qsizetype begin = 0;  ///< number of its first line in the text, from 0
    qsizetype count = 1;
    qsizetype base = -1;  ///< number of its first line in the file, from 0; −1 = written here
    QByteArray written;   ///< with its line end
  };

  /// An edit: lines in place of others.
  struct Splice {
    qsizetype first = 1;  ///< the first line that goes
    qsizetype count = 0;  ///< how many go
    std::vector<Piece> lines;
  };

  ProgramText() : ProgramText(QByteArray()) {}
  /// Looks through all of it; for long texts, something for a worker.
  explicit ProgramText(QByteArray bytes);

  qsizetype line_count() const { return pieces_.back().begin + pieces_.back().count; }
  qsizetype size() const;  ///< bytes
  /// A line without its end; UTF-8, or Latin-1 where it is not valid UTF-8. Empty where there is none.
  QString line(qsizetype number, qsizetype most_bytes = kWhole) const;
  /// The whole text in one piece; the file's own bytes where nothing was edited.
  QByteArray bytes() const;
  /// The whole text, piece by piece, as long as `take` returns true.
  void for_each_piece(const std::function<bool(std::string_view)>& take) const;

  /// Another text in a line, which has to be there. Line ends in it become spaces.
  Splice replacing(qsizetype number, const QString& text) const;
  /// An empty line after another one, which has to be there.
  Splice inserting_after(qsizetype number) const;
  /// Without lines that have to be there; where none would be left, one empty line stays.
  Splice removing(qsizetype first, qsizetype count) const;
  /// @return the edit that takes it back
  Splice apply(const Splice& splice);

  static constexpr qsizetype kWhole = -1;

 private:
  struct Base {
    QByteArray bytes;
    std::vector<qsizetype> starts;  ///< byte offset of each line; at least one entry, behind a mark of UTF-8
    bool utf8 = true;
  };

  QByteArrayView mark() const;  ///< of UTF-8, empty where there is none
  std::size_t piece_at(qsizetype index) const;
  std::size_t cut_before(qsizetype index);
  void renumber();
  QByteArrayView base_lines(qsizetype first, qsizetype count) const;
  QByteArrayView bytes_of(const Piece& piece) const;
  QByteArrayView raw_line(qsizetype number) const;
  QByteArray line_end(qsizetype number) const;
  QByteArray encoded(const QString& text) const;

  std::shared_ptr<const Base> base_;
  std::vector<Piece> pieces_;  // never empty
};

}  // namespace toolpace::ui
