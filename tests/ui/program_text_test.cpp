/// The text of a program under edit, and its undo.

#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include "models/program_model.h"
#include "models/program_text.h"
#include "support/ui_test.h"

using namespace toolpace::ui;

namespace {

QStringList lines_of(const ProgramText& text) {
  QStringList lines;
  for (qsizetype i = 1; i <= text.line_count(); ++i) lines << text.line(i);
  return lines;
}

QByteArray joined(const ProgramText& text) {
  QByteArray all;
  text.for_each_piece([&all](std::string_view piece) {
    all.append(piece.data(), static_cast<qsizetype>(piece.size()));
    return true;
  });
  return all;
}

}  // namespace

class ProgramTextTest : public QObject {
  Q_OBJECT

 private slots:
  void lines_are_found_whatever_their_ends() {
    QCOMPARE(lines_of(ProgramText("G1\r\nX1\n\nY2")), QStringList({"G1", "X1", "", "Y2"}));
    QCOMPARE(lines_of(ProgramText("G1\rX1\r")), QStringList({"G1", "X1"}));  // old Macintosh
    QCOMPARE(lines_of(ProgramText("a\n")), QStringList({"a"}));
    QCOMPARE(lines_of(ProgramText("")), QStringList({""}));
    QCOMPARE(lines_of(ProgramText()), QStringList({""}));
  }

  void a_line_that_is_not_utf8_is_shown_as_latin1_and_a_mark_is_not_shown() {
    QCOMPARE(ProgramText("(\xe4)").line(1), QString::fromUtf8("(ä)"));
    QCOMPARE(ProgramText("\xEF\xBB\xBFG1\nX1\n").line(1), QString("G1"));
  }

  void an_edit_keeps_every_byte_of_the_other_lines_and_the_end_of_its_own() {
    const std::pair<QByteArray, QByteArray> cases[] = {{"A\r\nB\r\nC", "A\r\nnew\r\nC"},
                                                       {"A\nB\n\xe4\n", "A\nnew\n\xe4\n"},
                                                       {"A\rB\rC\r", "A\rnew\rC\r"},
                                                       {"A\r\nB\nC\r\n", "A\r\nnew\nC\r\n"},
                                                       {"A\nB", "A\nnew"},
                                                       {"\xEF\xBB\xBF"
                                                        "A\nB\n",
                                                        "\xEF\xBB\xBF"
                                                        "A\nnew\n"}};
    for (const auto& [before, after] : cases) {
      ProgramText text(before);
      const auto back = text.apply(text.replacing(2, "new"));
      QCOMPARE(text.bytes(), after);
      QCOMPARE(joined(text), after);
      QCOMPARE(text.size(), after.size());
      text.apply(back);
      QCOMPARE(text.bytes(), before);
    }
  }

  void the_mark_of_utf8_stays_before_the_first_line() {
    ProgramText text(
        "\xEF\xBB\xBF"
        "A\nB\n");
    text.apply(text.replacing(1, "new"));
    QCOMPARE(text.bytes(), QByteArray("\xEF\xBB\xBFnew\nB\n"));
    text.apply(text.removing(1, 1));
    QCOMPARE(text.bytes(), QByteArray("\xEF\xBB\xBF"
                                      "B\n"));
  }

  void what_is_written_is_encoded_like_the_file_and_can_be_read_back() {
    ProgramText latin("(\xe4)\nX1\n");
    latin.apply(latin.replacing(2, QString::fromUtf8("(ü)")));
    QCOMPARE(latin.bytes(), QByteArray("(\xe4)\n(\xfc)\n"));
    // Latin-1 has no Ω, and "Ã¤" in Latin-1 would be read as "ä" in UTF-8.
    for (const char* word : {"(Ω)", "(Ã¤)"}) {
      latin.apply(latin.replacing(2, QString::fromUtf8(word)));
      QCOMPARE(latin.line(2), QString::fromUtf8(word));
      QCOMPARE(latin.line(1), QString::fromUtf8("(ä)"));
    }
    ProgramText ascii("X1\n");
    ascii.apply(ascii.replacing(1, QString::fromUtf8("(ü)")));
    QCOMPARE(ascii.bytes(), QByteArray("(ü)\n"));
  }

  void a_text_with_a_line_end_in_it_stays_one_line() {
    ProgramText text("A\nB\n");
    text.apply(text.replacing(1, "x\r\ny"));
    QCOMPARE(lines_of(text), QStringList({"x  y", "B"}));
  }

  void lines_are_added_with_the_line_end_of_their_neighbours() {
    ProgramText text("A\r\nB");
    auto back = text.apply(text.inserting_after(1));
    QCOMPARE(text.bytes(), QByteArray("A\r\n\r\nB"));
    text.apply(back);
    back = text.apply(text.inserting_after(2));  // the last line had no end and gets one
    QCOMPARE(text.bytes(), QByteArray("A\r\nB\r\n\r\n"));
    QCOMPARE(text.line_count(), 3);
    text.apply(back);
    QCOMPARE(text.bytes(), QByteArray("A\r\nB"));
  }

  void all_lines_can_go_and_come_back() {
    ProgramText text("A\nB\nC\n");
    const auto back = text.apply(text.removing(1, 3));
    QCOMPARE(lines_of(text), QStringList({""}));
    QCOMPARE(text.bytes(), QByteArray());
    text.apply(back);
    QCOMPARE(text.bytes(), QByteArray("A\nB\nC\n"));
  }

  void random_edits_are_those_of_a_list_of_lines_and_all_come_back() {
    std::uint32_t seed = 1;
    const auto next = [&seed](std::uint32_t below) { return (seed = seed * 1664525u + 1013904223u) / 65536u % below; };
    QByteArray file;
    for (int i = 0; i < 50; ++i) file += "N" + QByteArray::number(i) + "\n";
    ProgramText text(file);
    QStringList expected = lines_of(text);
    std::vector<ProgramText::Splice> back;
    for (int step = 0; step < 2000; ++step) {
      const auto at = static_cast<qsizetype>(next(static_cast<std::uint32_t>(expected.size()))) + 1;
      switch (next(3)) {
        case 0:
          back.push_back(text.apply(text.replacing(at, QString::number(step))));
          expected[at - 1] = QString::number(step);
          break;
        case 1:
          back.push_back(text.apply(text.inserting_after(at)));
          expected.insert(at, QString());
          break;
        default:
          if (expected.size() < 10) break;
          back.push_back(text.apply(text.removing(at, std::min<qsizetype>(3, expected.size() - at + 1))));
          for (qsizetype i = 0; i < 3 && at <= expected.size(); ++i) expected.removeAt(at - 1);
      }
      QVERIFY2(lines_of(text) == expected, qPrintable(QString("step %1").arg(step)));
    }
    QCOMPARE(lines_of(ProgramText(text.bytes())), expected);
    while (!back.empty()) {
      text.apply(back.back());
      back.pop_back();
    }
    QCOMPARE(text.bytes(), file);
    QCOMPARE(text.bytes().constData(), ProgramText(file).bytes().constData());  // the file's own bytes, not a copy
  }

  void taking_a_million_lines_away_remembers_where_they_were_not_what_they_said() {
    ProgramText text(QByteArray("G1 X1\n").repeated(1'000'000));
    const auto back = text.apply(text.removing(2, 999'998));
    QCOMPARE(back.lines.size(), std::size_t{1});
    QVERIFY(back.lines.front().written.isEmpty());
    QCOMPARE(text.line_count(), 2);
  }

  void edits_are_undone_and_the_saved_state_is_known_again() {
    QUndoStack stack;
    ProgramModel program(stack);
    program.open("/a.ngc", "a.ngc", ProgramText("A\nB\n"));
    QSignalSpy modified(&program, &ProgramModel::modifiedChanged);
    program.replaceLine(1, "A");  // says nothing new
    QVERIFY(!program.isModified() && !stack.canUndo());
    program.replaceLine(1, "X");
    QVERIFY(program.isModified());
    program.setSaved("/a.ngc", program.state());
    QVERIFY(!program.isModified());
    stack.undo();
    QVERIFY(program.isModified());  // the file says X now
    stack.redo();
    QVERIFY(!program.isModified());
    program.forgetSaved();
    QVERIFY(program.isModified());
    stack.undo();
    QVERIFY(program.isModified());
    QCOMPARE(modified.count(), 5);
  }

  void a_line_that_was_added_and_written_is_one_step() {
    QUndoStack stack;
    ProgramModel program(stack);
    program.open({}, "a.ngc", ProgramText("A\nB\n"));
    program.insertLineAfter(1);
    program.replaceLine(2, "new");
    QCOMPARE(program.text().bytes(), QByteArray("A\nnew\nB\n"));
    QCOMPARE(stack.count(), 1);
    program.replaceLine(2, "newer");  // a step of its own
    QCOMPARE(stack.count(), 2);
    stack.undo();
    QCOMPARE(program.text().bytes(), QByteArray("A\nnew\nB\n"));
    stack.undo();
    QCOMPARE(program.text().bytes(), QByteArray("A\nB\n"));
    QVERIFY(!program.isModified());
    stack.redo();
    QCOMPARE(program.text().bytes(), QByteArray("A\nnew\nB\n"));
  }

  void taking_the_files_text_can_be_undone_where_there_were_edits() {
    QUndoStack stack;
    ProgramModel program(stack);
    program.open("/a.ngc", "a.ngc", ProgramText("A\nB\n"));
    program.takeFile(ProgramText("other\n"));
    QVERIFY(!stack.canUndo() && !program.isModified());
    program.replaceLine(1, "mine");
    program.takeFile(ProgramText("theirs\n"));
    QVERIFY(!program.isModified());
    stack.undo();
    QCOMPARE(program.text().bytes(), QByteArray("mine\n"));
    QVERIFY(program.isModified());
    stack.undo();
    QCOMPARE(program.text().bytes(), QByteArray("other\n"));
    QVERIFY(program.isModified());
  }

  void steps_of_one_program_are_no_steps_of_the_next() {
    QUndoStack stack;
    ProgramModel program(stack);
    program.open("/a.ngc", "a.ngc", ProgramText("A\n"));
    program.replaceLine(1, "X");
    program.open("/b.ngc", "b.ngc", ProgramText("B\n"));
    QVERIFY(!stack.canUndo());
    QVERIFY(!program.isModified());
  }
};

TOOLPACE_UI_TEST(ProgramTextTest)
#include "program_text_test.moc"
