#include "support/meter.h"

#include <QFile>
#include <algorithm>
#include <ctime>

namespace toolpace::ui {
namespace {

double now_ms(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

Meter::Meter() : thread_(now_ms(CLOCK_THREAD_CPUTIME_ID)), process_(now_ms(CLOCK_PROCESS_CPUTIME_ID)) {}
double Meter::thread_ms() const { return now_ms(CLOCK_THREAD_CPUTIME_ID) - thread_; }
double Meter::process_ms() const { return now_ms(CLOCK_PROCESS_CPUTIME_ID) - process_; }

double memory_mb(const QByteArray& key) {
  QFile file("/proc/self/status");
  if (!file.open(QIODevice::ReadOnly)) return 0;
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (line.startsWith(key + ":")) return line.mid(key.size() + 1).trimmed().split(' ').first().toDouble() / 1024;
  }
  return 0;
}

Standstill::Standstill() {
  QObject::connect(&beat_, &QTimer::timeout, [this] { (void)longest_ms(); });
  beat_.start(1);
}

double Standstill::longest_ms() {
  longest_ = std::max(longest_, since_.thread_ms());
  since_ = Meter();
  return longest_;
}

}  // namespace toolpace::ui
