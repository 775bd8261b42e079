#include "support/memory_limit.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> most = SIZE_MAX;
std::atomic<int> refused = 0;
thread_local bool spared = false;

}  // namespace

// The program's own, so that all of it (Qt's code, too) asks here.
void* operator new(std::size_t bytes) {
  if (bytes > most.load(std::memory_order_relaxed) && !spared) {
    ++refused;
    throw std::bad_alloc();
  }
  if (void* const at = std::malloc(bytes > 0 ? bytes : 1)) return at;
  throw std::bad_alloc();
}
void operator delete(void* at) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }

namespace toolpace::ui {

MemoryLimit::MemoryLimit(std::size_t bytes) {
  spared = true;
  most = bytes;
}

MemoryLimit::~MemoryLimit() {
  most = SIZE_MAX;
  spared = false;
}

int MemoryLimit::refusals() { return refused; }

}  // namespace toolpace::ui
