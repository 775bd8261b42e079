#include "random_user/desk.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

namespace toolpace::ui {
namespace {

constexpr auto kSquare = "G21 G90 G94\nG1 F1200 X10\nY10\nX0\nY0\nM2\n";

struct Sheet {
  const char* name;
  QByteArray text;
};

const std::vector<Sheet>& programs() {
  static const std::vector<Sheet> all = {
      {"square.ngc", kSquare},
      {"arcs.ngc", "G21 G90 G94 F900\nG2 X10 Y0 I5 J0\nG3 X20 R5\nG1 Z-1\nG64 P0.05\nG1 X0\nY5\nX3\nM2\n"},
      {"turning.ngc", "G21 G90 G94 F600\nG1 X5 A90\nB45 Y2\nG0 A0 B0\nM2\n"},
      {"dwell.ngc", "G21 G90 F300\nG1 X1\nG4 P0.5\nM0\nG1 X2\nM2\n"},
      {"calls.nc",
       "%\nO1000\nG21 G90 G94 F500\n#1=0\nWHILE [#1 LT 20] DO1\nG1 X#1 Y[#1*#1/10]\n#1=[#1+1]\nEND1\nM30\n%\n"},
      {"line.csv", "x_mm,y_mm,z_mm,feed_mm_min\n0,0,0,600\n5,0,0,600\n5,5,-1,300\n"},
      {"bad arc.ngc", "G21 G90 F600\nG1 X10\nG2 X0 Y0 R1\nG1 X5\nM2\n"},
      {"no feed.ngc", "G21\nG1 X10\nM2\n"},
      {"empty.ngc", ""},
      {"binary.ngc", QByteArray("\x7f"
                                "ELF\0\1\2\xff\xfe",
                                8)},
      {"endless.ngc", "G21 F100\no1 while [1]\nG1 X1\nX0\no1 endwhile\nM2\n"},
      {"bad.csv", "x_mm,y_mm\n1,2\n3\nnan,inf\n"},
      {"中文.ngc", "G21 G90 F600\n(圆)\nG2 X0 Y0 I3\nM2\n"},
  };
  return all;
}

const std::vector<Sheet>& machines() {
  static const std::vector<Sheet> all = {
      {"slow.toml",
       "[machine]\nname = \"slow\"\n[path]\nmax_speed_mm_s = 20\nmax_acceleration_mm_s2 = 100\nmax_jerk_mm_s3 = "
       "2000\n"},
      {"axes.toml",
       "# kept\n[machine]\nperiod_ms = 2\n[axes.X]\nmax_speed_mm_s = 50\nmax_acceleration_mm_s2 = 400\nmax_jerk_mm_s3 "
       "= 8000\n"
       "steps_per_mm = 80\ntravel_mm = [-5, 8]\n[axes.Y]\nmax_speed_mm_s = 60\nmax_acceleration_mm_s2 = 500\n"
       "max_jerk_mm_s3 = 9000\nsteps_per_mm = 80\n[path]\nmax_speed_mm_s = 80\nmax_acceleration_mm_s2 = "
       "600\nmax_jerk_mm_s3 = 1e4\n"},
      {"grbl.txt", "$11=0.010\n$100=80\n$101=80\n$110=3000\n$111=3000\n$120=200\n$121=200\n$130=300\n"},
      {"linuxcnc.ini",
       "[TRAJ]\nMAX_LINEAR_VELOCITY = 50\n[AXIS_X]\nMAX_VELOCITY = 40\nMAX_ACCELERATION = 500\n"
       "MIN_LIMIT = -10\nMAX_LIMIT = 10\n"},
      {"broken.toml", "[path\nmax_speed_mm_s = fast\n"},
      {"unknown.toml", "[path]\nmax_sped_mm_s = 3\n"},
      {"empty.txt", ""},
  };
  return all;
}

}  // namespace

Desk::Desk() {
  for (const Sheet& sheet : ui::programs()) {
    write(QString::fromUtf8(sheet.name), sheet.text);
    programs_ << work_.filePath(QString::fromUtf8(sheet.name));
  }
  for (const Sheet& sheet : ui::machines()) {
    write(sheet.name, sheet.text);
    machines_ << work_.filePath(sheet.name);
  }
  programs_ << work_.filePath("not there.ngc") << work_.path() << "/dev/null";
  machines_ << work_.filePath("not there.toml") << work_.path() << programs_.front();
  for (const char* name : {"out.csv", "out.npy", "out.npz", "out.halstream", "out.semicolon.csv", "out.pulses.csv",
                           "out.png", "out.svg", "out.pdf", "out.html", "saved.toml", "saved.ngc", "nowhere/out.csv",
                           "nowhere/out.png", "out.unknown", "noextension"}) {
    targets_ << work_.filePath(name);
  }
  targets_ << work_.path() << "/dev/full";
  qputenv("TMPDIR", QFile::encodeName(temporaries_.path()));
}

void Desk::write(const QString& name, const QByteArray& text) const {
  QFile file(work_.filePath(name));
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("cannot write %s", qPrintable(name));
}

void Desk::disturb(Chance& chance) {
  const Sheet& sheet = one_of(chance, ui::programs());
  const QString name = QString::fromUtf8(sheet.name);
  switch (pick(chance, 4)) {
    case 0: return write(name, sheet.text);
    case 1: return write(name, sheet.text.left(sheet.text.size() / 2));
    case 2: return write(name, sheet.text + "G1 X1\n");
    default: QFile::remove(work_.filePath(name));
  }
}

QStringList Desk::leftovers() const {
  QStringList found;
  for (QDirIterator all(work_.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); all.hasNext();) {
    const QString name = QFileInfo(all.next()).fileName();
    if (name.startsWith('.') || name.endsWith(".tmp")) found << name;
  }
  found << QDir(temporaries_.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
  return found;
}

const QStringList& typed_lines() {
  static const QStringList lines = {"G1 X10 F600", "G0 Z5",     "G1 X1e9", "G2 X3 Y3 R2",      "",
                                    "(remark)",    "G1 X[1/0]", "garbage", "G1 X-3",           "F1",
                                    "G64 P0.1",    "M2",        "G20",     "G1 Y7 A360 F20000"};
  return lines;
}

}  // namespace toolpace::ui
