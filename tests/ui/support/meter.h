#pragma once
/// What things cost, in processor time, so that a busy machine does not matter, and in memory.

#include <QByteArray>
#include <QTimer>

namespace toolpace::ui {

/// Processor time since it was made [ms].
class Meter {
 public:
  Meter();
  double thread_ms() const;   ///< of the thread that asks
  double process_ms() const;  ///< of all threads

 private:
  double thread_, process_;
};

/// A line of /proc/self/status [MB], such as "VmRSS"; 0 where there is none.
double memory_mb(const QByteArray& key);

/// The longest that the event loop of its thread worked without coming back, since it was made [ms of processor time].
class Standstill {
 public:
  Standstill();
  double longest_ms();

 private:
  QTimer beat_;
  Meter since_;
  double longest_ = 0;
};

}  // namespace toolpace::ui
