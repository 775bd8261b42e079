/// Thousands of things that somebody does with the window, at random. TOOLPACE_USER_ACTIONS (100) and TOOLPACE_USER_SEED (1)
/// choose how many and which; TOOLPACE_USER_TRACE prints each before it is done.

#include <execinfo.h>
#include <unistd.h>

#include <QSettings>
#include <QTest>
#include <array>
#include <csignal>
#include <cstdio>

#include "random_user/user.h"
#include "support/ui_test.h"

namespace {

using namespace toolpace::ui;

constexpr int kUsualActions = 100, kBetweenDeepLooks = 40;

struct Place {
  unsigned long long seed = 2;
  int step = 0;
  QByteArray last;
};
Place place;

int number_from_environment(const char* name, int usual) {
  bool given = false;
  const int number = qEnvironmentVariableIntValue(name, &given);
  return given ? number : usual;
}

/// Where it was when the process dies, and in which calls (addr2line names their lines).
void tell_place(int signal) {
  std::fprintf(stderr, "random user: seed %llu, step %d, after: %s\n", place.seed, place.step, place.last.constData());
  std::array<void*, 64> calls = {};
  backtrace_symbols_fd(calls.data(), backtrace(calls.data(), static_cast<int>(calls.size())), STDERR_FILENO);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// What Qt warns of is a mistake of ours, but for what the platform without a display cannot do.
QStringList warnings;
void take_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtFatalMsg) {
    std::fprintf(stderr, "%s\n", qPrintable(text));
    std::abort();
  }
  const bool of_the_platform = text.contains("This plugin does not support") || text.contains("propagateSizeHints");
  const bool of_the_test = text.startsWith("Mouse event") || text.contains("occurs outside target window");
  if (type != QtDebugMsg && type != QtInfoMsg && !of_the_platform && !of_the_test) warnings << text;
}

}  // namespace

class RandomUserTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings_.path()); }

  void whatever_somebody_does_the_window_makes_sense() {
    place.seed = static_cast<unsigned long long>(number_from_environment("TOOLPACE_USER_SEED", 2));
    const int actions = number_from_environment("TOOLPACE_USER_ACTIONS", kUsualActions);
    const bool traced = qEnvironmentVariableIsSet("TOOLPACE_USER_TRACE");
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) std::signal(signal, tell_place);
    RandomUser user(place.seed);
    qInstallMessageHandler(take_message);
    for (place.step = 1; place.step <= actions; ++place.step) {
      place.last = user.act().toUtf8();
      if (traced) std::fprintf(stderr, "%d %s\n", place.step, place.last.constData());
      QString wrong = user.trouble();
      if (wrong.isEmpty() && place.step % kBetweenDeepLooks == 0) wrong = user.deep_trouble();
      if (wrong.isEmpty() && !warnings.isEmpty()) wrong = "Qt warns: " + warnings.join("; ");
      if (wrong.isEmpty()) continue;
      qInstallMessageHandler(nullptr);
      QFAIL(qPrintable(QString("seed %1, step %2: %3; after it: %4")
                           .arg(place.seed)
                           .arg(place.step)
                           .arg(QString::fromUtf8(place.last), wrong)));
    }
    qInstallMessageHandler(nullptr);
    std::printf("random user: %d actions, seed %llu\n", actions, place.seed);
  }

 private:
  QTemporaryDir settings_;
};

TOOLPACE_UI_TEST(RandomUserTest)
#include "random_user_test.moc"
