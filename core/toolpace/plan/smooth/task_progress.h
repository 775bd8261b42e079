#pragma once
/// Progress of tasks that run side by side.

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "toolpace/base/monitor.h"

namespace toolpace::detail::tube {

/// Counts finished tasks from any thread and reports them in order, one at a time; who finds another one reporting does
/// not wait.
class TaskProgress {
 public:
  /// @param whole  what all tasks add up to, > 0
  TaskProgress(const Monitor& monitor, std::size_t whole) : monitor_(monitor), whole_(whole) {}

  /// @param amount  of the whole that one task has done
  void add(std::size_t amount) {
    done_ += amount;
    if (reporting_.test_and_set()) return;
    monitor_.report(std::min(1.0, static_cast<double>(done_.load()) / static_cast<double>(whole_)));
    reporting_.clear();
  }

 private:
  const Monitor& monitor_;
  std::size_t whole_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic_flag reporting_;
};

}  // namespace toolpace::detail::tube
