#include "meter.h"

#include <malloc.h>

#include <ctime>
#include <fstream>
#include <string>

namespace toolpace::bench {
namespace {

double now(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// A line of /proc/self/status [B]; 0 where there is none.
double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == key + ":" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

}  // namespace

Meter::Meter() : thread_(now(CLOCK_THREAD_CPUTIME_ID)), process_(now(CLOCK_PROCESS_CPUTIME_ID)) {}
double Meter::thread() const { return now(CLOCK_THREAD_CPUTIME_ID) - thread_; }
double Meter::process() const { return now(CLOCK_PROCESS_CPUTIME_ID) - process_; }

double peak_bytes(const std::function<void()>& work) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak counts from here
  const double before = status_bytes("VmRSS");
  work();
  return status_bytes("VmHWM") - before;
}

}  // namespace toolpace::bench
