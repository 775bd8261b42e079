/// The command toolpace-studio: what it prints, how it exits, and what it leaves behind.

#include <signal.h>
#include <sys/stat.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "support/files.h"
#include "support/patience.h"
#include "support/ui_test.h"

using toolpace::ui::write;

namespace {

struct Ended {
  int code;
  QString out, errors;
};

}  // namespace

class StudioCommandTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString in(const QString& name) const { return folder_.filePath(name); }

  /// @param display  "" = none at all
  static void prepare(QProcess& process, const QString& display) {
    auto environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
    if (!display.isEmpty()) environment.insert("QT_QPA_PLATFORM", display);
    process.setProcessEnvironment(environment);
  }

  static Ended run(const QStringList& arguments, const QString& display = "offscreen") {
    QProcess process;
    prepare(process, display);
    process.start(TOOLPACE_STUDIO, arguments);
    if (!process.waitForFinished(120'000)) qFatal("does not end: %s", qPrintable(arguments.join(' ')));
    const int code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    return {code, process.readAllStandardOutput(), process.readAllStandardError()};
  }

 private slots:
  void init() { write(in("square.ngc"), "G21 G90 G94\nG1 F1200 X10\nY10\nX0\nY0\nM2\n"); }

  void help_and_version_need_no_display() {
    for (const char* flag : {"--help", "-h"}) {
      const auto help = run({flag}, {});
      QCOMPARE(help.code, 0);
      QVERIFY2(help.out.contains("--screenshot") && help.out.startsWith("Usage: "), qPrintable(help.out));
    }
    const auto version = run({"--version"}, {});
    QCOMPARE(version.code, 0);
    QVERIFY(version.out.startsWith("toolpace-studio "));
  }

  void what_a_controller_does_is_in_the_picture_or_its_error_told() {
    write(in("grbl.txt"), "$11=0.01\n$12=0.002\n$110=6000\n$111=6000\n$112=600\n$120=500\n$121=500\n$122=50\n");
    const auto shown =
        run({in("square.ngc"), "--controller", in("grbl.txt"), "--screenshot", in("both.png"), "--size", "1280x800"});
    QVERIFY2(shown.code == 0, qPrintable(shown.errors));
    const auto alone = run({in("square.ngc"), "--screenshot", in("alone.png"), "--size", "1280x800"});
    QCOMPARE(alone.code, 0);
    QVERIFY(QImage(in("both.png")) != QImage(in("alone.png")));
    const auto missing = run({in("square.ngc"), "--controller", in("none.txt"), "--screenshot", in("none.png")});
    QCOMPARE(missing.code, 4);
    QVERIFY2(missing.errors.contains("none.txt"), qPrintable(missing.errors));
    QVERIFY(!QFile::exists(in("none.png")));
  }

  void bad_usage_is_said_without_a_display() {
    const QList<QStringList> bad = {{"--no-such-option"},      {"a.ngc", "b.ngc"},  {"--size", "12"},
                                    {"--language", "klingon"}, {"--theme", "pink"}, {"--machine"},
                                    {"--screenshot", "a.bmp"}, {"--screenshot", ""}};
    for (const QStringList& arguments : bad) {
      const auto ended = run(arguments, {});
      QVERIFY2(ended.code == 2, qPrintable(arguments.join(' ')));
      QVERIFY2(ended.errors.startsWith("error: ") || ended.errors.contains(": error: "), qPrintable(ended.errors));
    }
    QVERIFY(run({"--screenshot", "a.bmp"}, {}).errors.contains("use one of .png"));
  }

  void options_of_qt_go_to_qt() {
    QCOMPARE(run({"-platform", "offscreen", in("square.ngc"), "--screenshot", in("qt.png")}, {}).code, 0);
    QVERIFY(!QImage(in("qt.png")).isNull());
  }

  void a_picture_needs_no_display_and_shows_errors_of_the_program() {
    write(in("bad.ngc"), "G21 G90 F600\nG1 X10\nG2 X0 Y0 R1\nM2\n");
    const auto ended = run({in("bad.ngc"), "--screenshot", in("bad.PNG"), "--size", "900x600"}, {});
    QCOMPARE(ended.code, 0);
    QCOMPARE(QImage(in("bad.PNG")).size(), QSize(900, 600));
  }

  void a_bad_machine_is_told_as_the_command_line_tells_it() {
    write(in("bad.toml"), "[path]\nmax_sped_mm_s = 3\n");
    const auto ended = run({in("square.ngc"), "--machine", in("bad.toml"), "--screenshot", in("machine.png")});
    QCOMPARE(ended.code, 2);
    QVERIFY2(ended.errors.contains(in("bad.toml") + ":2:1: error: "), qPrintable(ended.errors));
    QVERIFY(ended.errors.contains("max_speed_mm_s"));
    QVERIFY(!QFile::exists(in("machine.png")));
    const auto missing = run({"--machine", in("none.toml"), "--screenshot", in("machine.png")});
    QCOMPARE(missing.code, 4);
    QVERIFY2(missing.errors.contains("none.toml"), qPrintable(missing.errors));
  }

  void a_missing_program_and_a_target_that_cannot_be_written_exit_with_4() {
    const auto missing = run({in("none.ngc"), "--screenshot", in("none.png")});
    QCOMPARE(missing.code, 4);
    QVERIFY2(missing.errors.contains("none.ngc: error: "), qPrintable(missing.errors));
    QVERIFY(!QFile::exists(in("none.png")));
    const auto folder = run({in("square.ngc"), "--screenshot", in("no/such/a.png")});
    QCOMPARE(folder.code, 4);
    QVERIFY2(folder.errors.contains("no/such/a.png: error: "), qPrintable(folder.errors));
    const auto full = run({in("square.ngc"), "--screenshot", "/dev/full"});
    QCOMPARE(full.code, 4);
    QVERIFY2(full.errors.contains("no space is left"), qPrintable(full.errors));
  }

  void pipes_and_devices_are_refused_as_program_and_as_machine() {
    QCOMPARE(::mkfifo(QFile::encodeName(in("pipe.ngc")).constData(), 0600), 0);
    QCOMPARE(::mkfifo(QFile::encodeName(in("pipe.toml")).constData(), 0600), 0);
    for (const QString& program : {QString("/dev/zero"), in("pipe.ngc")}) {
      const auto ended = run({program, "--screenshot", in("pipe.png")});
      QCOMPARE(ended.code, 4);
      QVERIFY2(ended.errors.contains("it is a pipe, a socket or a device"), qPrintable(ended.errors));
    }
    for (const QString& machine : {QString("/dev/zero"), in("pipe.toml")}) {
      const auto ended = run({"--machine", machine, "--screenshot", in("pipe.png")});
      QCOMPARE(ended.code, 4);
      QVERIFY2(ended.errors.contains("it is a pipe, a socket or a device"), qPrintable(ended.errors));
    }
  }

  void signals_end_it_in_order() {
    // Long enough to be still at it: smoothing a winding path of 20 000 corners.
    QByteArray text = "G21 G90 G94 F6000\n";
    for (int i = 0; i < 20'000; ++i) {
      text += "G1 X" + QByteArray::number(0.1 * i) + " Y" + QByteArray::number(i % 2) + "\n";
    }
    write(in("long.ngc"), text + "M2\n");
    write(in("smooth.toml"),
          "[path]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 1e5\n"
          "[lookahead]\ncorner = \"smooth\"\n"
          "[axes.X]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 1e5\n"
          "[axes.Y]\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 1e5\n");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
      QProcess process;
      prepare(process, "offscreen");
      process.start(TOOLPACE_STUDIO, {in("long.ngc"), "--machine", in("smooth.toml"), "--screenshot", in("long.png")});
      QVERIFY(process.waitForStarted());
      // The handlers stand once the process catches the signal.
      const auto caught = [&process] {
        QFile status(QString("/proc/%1/status").arg(process.processId()));
        if (!status.open(QIODevice::ReadOnly)) return false;
        for (const QByteArray& line : status.readAll().split('\n')) {
          if (line.startsWith("SigCgt:"))
            return (line.mid(7).trimmed().toULongLong(nullptr, 16) >> (SIGHUP - 1) & 1) != 0;
        }
        return false;
      };
      TOOLPACE_EVENTUALLY(caught());
      QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
      QVERIFY(process.waitForFinished(60'000));
      QCOMPARE(process.exitStatus(), QProcess::NormalExit);
      QCOMPARE(process.exitCode(), 130);
    }
    QVERIFY(!QFile::exists(in("long.png")));
  }
};

TOOLPACE_UI_TEST(StudioCommandTest)
#include "studio_command_test.moc"
