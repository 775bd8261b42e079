#pragma once
/// How a planner hands out work that may be done at the same time: threads are the pipeline's business.

#include <cstddef>
#include <functional>

namespace toolpace {

/// Runs task(0) … task(count − 1), in any order, on any threads, and returns when all are done.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

/// The same on the calling thread.
inline void for_each_in_turn(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = 0; i < count; ++i) task(i);
}

}  // namespace toolpace
