#pragma once
/// What work costs in processor time, so that a busy machine does not matter, and in memory.

#include <functional>

namespace toolpace::bench {

/// Processor time since it was made [s].
class Meter {
 public:
  Meter();
  double thread() const;   ///< of the thread that asks
  double process() const;  ///< of all threads

 private:
  double thread_, process_;
};

/// By how much the work raises the memory in use at its peak [B]; 0 where the system does not tell.
double peak_bytes(const std::function<void()>& work);

}  // namespace toolpace::bench
