/// Export ▸ Program for this controller…, as a person uses it.

#include "rewrite_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numbers>

#include "opened.h"
#include "panels/number_field.h"
#include "preview/contour_canvas.h"
#include "support/dialogs.h"
#include "support/files.h"
#include "support/screenshot.h"
#include "support/ui_test.h"

using namespace toolpace;
using namespace toolpace::ui;
using studio::RewriteDialog;

namespace {

/// A circle of 10 mm in 400 chords, between words that have to stay.
QByteArray chords() {
  QByteArray text = "(a circle)\nG21 G90 G17 G94\nM3 S9000\nG0 X10 Y0\nG1 Z-1 F300\nF1200\n";
  for (int i = 1; i <= 400; ++i) {
    const double angle = 2 * std::numbers::pi * i / 400;
    text += QString("G1 X%1 Y%2\n").arg(10 * std::cos(angle), 0, 'f', 4).arg(10 * std::sin(angle), 0, 'f', 4).toUtf8();
  }
  return text + "M5\nM2\n";
}

const QByteArray kGrbl =
    "$0=10\n$11=0.010\n$12=0.002\n$100=80\n$101=80\n$102=400\n$110=5000\n$111=5000\n$112=500\n"
    "$120=200\n$121=200\n$122=50\nok\n";

RewriteDialog& rewriting(QWidget& dialog) {
  auto& found = dynamic_cast<RewriteDialog&>(dialog);
  eventually([&] { return !found.isWorking(); });
  return found;
}

void enter_number(QWidget& dialog, const char* name, const QString& text) {
  auto& field = find<NumberField>(dialog, name);
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

QString cell(QWidget& dialog, const char* table, int row, int column) {
  return find<QTableWidget>(dialog, table).item(row, column)->text();
}

}  // namespace

class RewriteDialogTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }

 private slots:
  void it_works_at_once_shows_the_gain_and_saves_what_it_shows() {
    write(in("chords.ngc"), chords());
    Opened window;
    window.openProgram(in("chords.ngc"));
    studio::settle(window);
    std::unique_ptr<NextDialog> name;
    const NextDialog see([&](QWidget& dialog) {
      const auto closed = qScopeGuard([&] { dialog.close(); });
      auto& rewrite = rewriting(dialog);
      QVERIFY2(rewrite.found(), qPrintable(find<QLabel>(dialog, "rewriteState").text()));
      QCOMPARE(cell(dialog, "rewriteSummary", 0, 0), QString("Blocks"));
      QVERIFY(cell(dialog, "rewriteSummary", 0, 1).toInt() >= 400);
      QVERIFY(cell(dialog, "rewriteSummary", 0, 2).toInt() <= 8);
      QVERIFY(find<QTableWidget>(dialog, "rewriteRanges").rowCount() >= 1);
      QVERIFY(rewrite.found()->rewritten.max_deviation <= 0.01);
      QVERIFY(rewrite.found()->scene->trace);  // drawn over each other
      QVERIFY(find<QComboBox>(dialog, "rewriteEnlargement").currentData().toInt() >= 10);
      studio::settle(window);
      QVERIFY(colours_in(screenshot(dialog, "rewrite-dialog")) > 10);
      QTest::mouseClick(&find<QPushButton>(dialog, "rewriteSave"), Qt::LeftButton);
      name.reset(new NextDialog(file_named(in("short.ngc"))));
    });
    window.actions().export_program->trigger();
    TOOLPACE_EVENTUALLY(QFile::exists(in("short.ngc")));
    const QByteArray text = content(in("short.ngc"));
    QVERIFY(text.startsWith("(a circle)\nG21 G90 G17 G94\nM3 S9000\nG0 X10 Y0\n"));
    QVERIFY(text.endsWith("M5\nM2\n"));
    QVERIFY(text.size() < 300);
    TOOLPACE_EVENTUALLY(window.isSettled());
  }

  void a_change_works_anew_and_a_controller_counts_its_own_time() {
    write(in("chords.ngc"), chords());
    write(in("grbl.txt"), kGrbl);
    Opened window;
    window.openProgram(in("chords.ngc"));
    QVERIFY(window.openController(in("grbl.txt")));
    studio::settle(window);
    const NextDialog see([&](QWidget& dialog) {
      const auto closed = qScopeGuard([&] { dialog.close(); });
      auto& rewrite = rewriting(dialog);
      QVERIFY(rewrite.found());
      QVERIFY(find<QComboBox>(dialog, "rewriteController").currentText().startsWith("grbl"));
      const auto on_grbl = rewrite.found();
      QVERIFY(*on_grbl->rewritten.time_after <= *on_grbl->rewritten.time_before * (1 + 1e-9));
      find<QCheckBox>(dialog, "rewriteArcs").click();
      QVERIFY(rewrite.isWorking() && !find<QPushButton>(dialog, "rewriteSave").isEnabled());
      rewriting(dialog);
      QVERIFY(rewrite.found() && rewrite.found() != on_grbl);
      QVERIFY(rewrite.found()->blocks_after > on_grbl->blocks_after);  // lines alone take more of them
      enter_number(dialog, "rewriteTolerance", "0.1");
      rewriting(dialog);
      QCOMPARE(rewrite.found()->tolerance, 0.1);
      QVERIFY(rewrite.found()->rewritten.max_deviation <= 0.1);
      auto& controllers = find<QComboBox>(dialog, "rewriteController");
      controllers.setCurrentIndex(0);
      emit controllers.activated(0);
      rewriting(dialog);
      QVERIFY(std::abs(*rewrite.found()->rewritten.time_before - window.workspace().timeline()->duration()) < 1e-9);
      QVERIFY(!find<NumberField>(dialog, "rewriteBaud").isEnabled());
      QTest::mouseClick(&find<QPushButton>(dialog, "rewriteClose"), Qt::LeftButton);
    });
    window.actions().export_program->trigger();
  }

  void nothing_that_is_open_is_written_over() {
    write(in("chords.ngc"), chords());
    Opened window;
    window.openProgram(in("chords.ngc"));
    studio::settle(window);
    QSignalSpy failed(&window, &studio::MainWindow::failed);
    const auto document = window.workspace().document();
    const auto found = rewrite_document({document, {}, {window.workspace().tuning().value(), {}, {}, true, false}}, {});
    QVERIFY(found);
    window.storeRewritten(*found, in("chords.ngc"));
    QCOMPARE(failed.count(), 1);
    QCOMPARE(content(in("chords.ngc")), chords());
    window.storeRewritten(*found, in("no/such/folder.ngc"));
    TOOLPACE_EVENTUALLY(failed.count() == 2);
  }

  void a_program_with_errors_says_why_and_saves_nothing() {
    Opened window;
    window.open("G1 X10 F100\nG1 X1O\nM2\n");
    const NextDialog see([&](QWidget& dialog) {
      const auto closed = qScopeGuard([&] { dialog.close(); });
      QVERIFY(!rewriting(dialog).found());
      QVERIFY(!find<QPushButton>(dialog, "rewriteSave").isEnabled());
      QVERIFY(!find<QLabel>(dialog, "rewriteState").text().isEmpty());
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    window.actions().export_program->trigger();
  }

  void pictures_in_chinese_and_dark() {
    Opened window;
    window.setLanguage("zh_CN");
    window.setDark(true);
    window.open(chords());
    const NextDialog see([&](QWidget& dialog) {
      const auto closed = qScopeGuard([&] { dialog.close(); });
      rewriting(dialog);
      studio::settle(window);
      QVERIFY(colours_in(screenshot(dialog, "rewrite-dialog-zh_CN")) > 10);
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    window.actions().export_program->trigger();
  }
};

TOOLPACE_UI_TEST(RewriteDialogTest)
#include "rewrite_dialog_test.moc"
