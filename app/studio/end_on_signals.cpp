#include "end_on_signals.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QSocketNotifier>
#include <cerrno>

#include "command_line.h"

namespace toolpace::studio {
namespace {

volatile sig_atomic_t ended = 0;
int wake_up[2] = {-1, -1};  // a pipe: hardly anything else may be touched by a handler

void end(int) {
  const int before = errno;
  ended = 1;
  const char byte = 0;
  if (::write(wake_up[1], &byte, 1) < 0) {
    // full: somebody has been told already
  }
  errno = before;
}

}  // namespace

void end_on_signals(QObject* owner) {
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  if (::pipe2(wake_up, O_CLOEXEC | O_NONBLOCK) != 0) return;
  auto* notifier = new QSocketNotifier(wake_up[0], QSocketNotifier::Read, owner);
  QObject::connect(notifier, &QSocketNotifier::activated, owner, [notifier] {
    notifier->setEnabled(false);
    QCoreApplication::exit(kInterrupted);
  });
  struct sigaction action {};
  action.sa_handler = end;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::sigaction(signal, &action, nullptr);
}

bool is_ended() { return ended != 0; }

}  // namespace toolpace::studio
