#pragma once
/// The same work on many values, on all cores, with the results in the order of the values.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include "toolpace/base/monitor.h"

namespace toolpace {

/// Whole plans that are made side by side: each holds its own path and limits in memory.
inline constexpr std::size_t kPlansAtOnce = 2;

/// Calls work(i, monitor) -> Result<T> for i = 0 … count − 1 on up to `threads` threads. The first error in the order
/// of i is returned; cancelling stops all. Progress counts finished items. What work throws, on whatever thread, is
/// thrown here once all threads have come to an end.
template <class T, class Work>
Result<std::vector<T>> for_many(std::size_t count, std::size_t threads, const Monitor& monitor, const Work& work) {
  std::vector<std::optional<Result<T>>> results(count);
  std::atomic<std::size_t> next = 0;
  std::mutex shared;
  std::size_t done = 0;
  std::exception_ptr thrown;
  const auto worker = [&] {
    try {
      const Monitor quiet{monitor.stop, {}};
      for (std::size_t i = next++; i < count && !monitor.is_cancelled(); i = next++) {
        results[i].emplace(work(i, quiet));
        const std::scoped_lock lock(shared);
        monitor.report(static_cast<double>(++done) / static_cast<double>(count));
      }
    } catch (...) {
      const std::scoped_lock lock(shared);
      if (!thrown) thrown = std::current_exception();
      next = count;  // nobody needs the rest
    }
  };
  {
    std::vector<std::jthread> helpers;
    try {
      for (std::size_t k = 1; k < std::min(threads, count); ++k) helpers.emplace_back(worker);
    } catch (const std::system_error&) {  // the system has no more threads to give: those that there are do the work
    }
    worker();
  }
  if (thrown) std::rethrow_exception(thrown);
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  std::vector<T> values;
  values.reserve(count);
  for (auto& result : results) {
    if (!*result) return tl::unexpected(result->error());
    values.push_back(std::move(**result));
  }
  return values;
}

}  // namespace toolpace
