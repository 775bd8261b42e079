#pragma once
/// Memory that runs out in workers.

#include <cstddef>

namespace toolpace::ui {

/// While it lives, every thread but the one that made it gets std::bad_alloc for pieces of more than `bytes`.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes);
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit();

  /// How often it was too much, of all limits so far.
  static int refusals();
};

}  // namespace toolpace::ui
