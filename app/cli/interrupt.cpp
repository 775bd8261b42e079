#include "interrupt.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <thread>

#include "console.h"

namespace toolpace::cli {
namespace {

constexpr int kWakeUp = SIGUSR1;
constexpr timespec kBetweenWakeUps = {0, 20'000'000};

std::stop_source& stop_source() {
  static std::stop_source source;
  return source;
}

bool progress_shown = false;

bool is_ignored(int number) {
  struct sigaction action {};
  return sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// The signals that ask the process to end. One that is started with nohup is not asked by SIGHUP.
sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGQUIT}) sigaddset(&signals, number);
  if (!is_ignored(SIGHUP)) sigaddset(&signals, SIGHUP);
  return signals;
}

/// A signal whose arrival ends a system call that waits, and does nothing else.
void listen_to_wake_ups() {
  struct sigaction nothing {};
  nothing.sa_handler = [](int) {};  // and no SA_RESTART
  sigaction(kWakeUp, &nothing, nullptr);
  sigset_t wake_up;
  sigemptyset(&wake_up);
  sigaddset(&wake_up, kWakeUp);
  pthread_sigmask(SIG_UNBLOCK, &wake_up, nullptr);
}

/// Waits for the first signal, asks for a stop, and wakes the worker again and again: a call may begin to wait just
/// after one came. SIGHUP and SIGTERM often come as a pair; only the same one twice is impatience.
void serve(const sigset_t& signals, pthread_t worker, std::stop_source source) {
  int first = 0;
  sigwait(&signals, &first);
  source.request_stop();
  for (;;) {
    const int next = sigtimedwait(&signals, nullptr, &kBetweenWakeUps);
    if (next == first) _exit(130);
    pthread_kill(worker, kWakeUp);
  }
}

}  // namespace

void catch_interrupts() {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  listen_to_wake_ups();
  const sigset_t signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, worker = pthread_self(), source = stop_source()] { serve(signals, worker, source); }).detach();
}

bool is_interrupted() { return stop_source().stop_requested(); }

Monitor terminal_monitor(const char* what) {
  if (Console* other = console()) return other->monitor(what);
  Monitor monitor{stop_source().get_token(), {}};
  if (isatty(STDERR_FILENO)) {
    monitor.progress = [what, last = std::make_shared<int>(-1)](double fraction) {
      const int percent = static_cast<int>(100 * fraction);
      if (percent == *last) return;
      *last = percent;
      progress_shown = true;
      std::fputs(fmt::format("\r{} {} %", what, percent).c_str(), stderr);  // a terminal that is gone is no error
    };
  }
  return monitor;
}

void end_progress() {
  if (console()) return;
  if (progress_shown) std::fputs("\r\033[K", stderr);
  progress_shown = false;
}

}  // namespace toolpace::cli
