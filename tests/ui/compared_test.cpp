/// What a real controller does, as plan B beside the own one.

#include <QSignalSpy>
#include <QTest>

#include "opened.h"
#include "support/files.h"
#include "support/ui_test.h"
#include "toolpace/controller/prediction.h"
#include "toolpace/nc/reader.h"

using namespace toolpace;
using namespace toolpace::ui;

namespace {

const QByteArray kProgram = "G21 G90 G17\nG1 X30 F6000\nG3 X30 Y0 I0 J2\nG1 X40 Y5\nM2\n";
const QByteArray kGrbl =
    "$1=25\n$11=0.01\n$12=0.002\n$100=80\n$101=80\n$102=400\n$110=6000\n$111=6000\n$112=600\n$120=500\n$121=500\n";

double predicted(const QByteArray& settings) {
  ReadOptions options;
  options.dialect = Dialect::grbl;
  const std::string_view text(kProgram.constData(), static_cast<std::size_t>(kProgram.size()));
  const auto reading = read_text(text, "p.nc", options);
  const auto parsed = parse_controller_settings(settings.toStdString(), "settings", Controller::grbl);
  return predict(*reading, scan_program(text), *parsed)->cycle_time;
}

/// A file in a folder. @return its path
QString file(const QTemporaryDir& folder, const char* name, const QByteArray& text) {
  const QString path = folder.filePath(name);
  write(path, text);
  return path;
}

}  // namespace

class ComparedTest : public QObject {
  Q_OBJECT

 private slots:
  void a_controllers_motion_is_plan_b() {
    Opened window({1280, 800});
    Workspace& workspace = window.workspace();
    workspace.openText(kProgram, "p.nc");
    studio::settle(window);
    const auto own = workspace.plan().timeline->outcome();
    QTemporaryDir folder;
    const QString path = file(folder, "grbl.txt", kGrbl);
    workspace.pinController(path);
    QTRY_VERIFY(workspace.pinned());
    QCOMPARE(workspace.pinned().timeline->duration(), predicted(kGrbl));
    QVERIFY(workspace.plan().timeline->outcome() == own);
    // $122 is missing, which is told.
    QVERIFY(std::any_of(workspace.problems().begin(), workspace.problems().end(),
                        [](const Diagnostic& d) { return d.code == "settings-defaulted"; }));
    workspace.unpin();
    QVERIFY(!workspace.pinned());
  }

  void what_cannot_be_read_is_said_and_changes_nothing() {
    Opened window({1280, 800});
    Workspace& workspace = window.workspace();
    workspace.openText(kProgram, "p.nc");
    studio::settle(window);
    QSignalSpy failed(&workspace, &Workspace::controllerFailed);
    QTemporaryDir folder;
    workspace.pinController(folder.filePath("none.txt"));
    QTRY_COMPARE(failed.count(), 1);
    workspace.pinController(file(folder, "note.txt", "buy milk\n"));
    QTRY_COMPARE(failed.count(), 2);
    QCOMPARE(QString::fromStdString(failed.last().first().value<Error>().code), QString("settings-unknown"));
    workspace.pinController(file(folder, "mill.ini",
                                 "[TRAJ]\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 200\n[AXIS_X]\n"
                                 "MAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n"));
    QTRY_COMPARE(failed.count(), 3);
    QCOMPARE(QString::fromStdString(failed.last().first().value<Error>().code), QString("controller-blends"));
    QVERIFY(!workspace.pinned());
  }

  void cancel_ends_it() {
    Opened window({1280, 800});
    Workspace& workspace = window.workspace();
    workspace.openText(kProgram, "p.nc");
    studio::settle(window);
    QTemporaryDir folder;
    QSignalSpy failed(&workspace, &Workspace::controllerFailed);
    workspace.pinController(file(folder, "grbl.txt", kGrbl));
    workspace.cancel();
    QTRY_VERIFY(!workspace.isBusy());
    QVERIFY(!workspace.pinned());
    QCOMPARE(failed.count(), 0);
  }
};

TOOLPACE_UI_TEST(ComparedTest)
#include "compared_test.moc"
