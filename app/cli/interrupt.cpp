#include "interrupt.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <thread>

namespace toolpace::cli {
namespace {

std::stop_source& stop_source() {
  static std::stop_source source;
  return source;
}

bool progress_shown = false;

}  // namespace

void catch_interrupts() {
  signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, source = stop_source()]() mutable {
    int signal = 0;
    sigwait(&signals, &signal);
    source.request_stop();
    sigwait(&signals, &signal);  // asked twice: go at once
    _exit(130);
  }).detach();
}

Monitor terminal_monitor(const char* what) {
  Monitor monitor{stop_source().get_token(), {}};
  if (isatty(STDERR_FILENO)) {
    monitor.progress = [what, last = std::make_shared<int>(-1)](double fraction) {
      const int percent = static_cast<int>(100 * fraction);
      if (percent == *last) return;
      *last = percent;
      progress_shown = true;
      fmt::print(stderr, "\r{} {} %", what, percent);
    };
  }
  return monitor;
}

void end_progress() {
  if (progress_shown) std::fputs("\r\033[K", stderr);
  progress_shown = false;
}

}  // namespace toolpace::cli
