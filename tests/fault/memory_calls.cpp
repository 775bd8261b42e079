/// The C library's allocations, which operator new uses, too: any of them can be refused.

#include <cerrno>
#include <cstddef>

#include "faults.h"

using toolpace::test::refuses_memory;

extern "C" {

void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* old, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);

void* malloc(std::size_t bytes) { return refuses_memory(bytes) ? nullptr : __libc_malloc(bytes); }

void* calloc(std::size_t count, std::size_t bytes) {
  return refuses_memory(count * bytes) ? nullptr : __libc_calloc(count, bytes);
}

void* realloc(void* old, std::size_t bytes) { return refuses_memory(bytes) ? nullptr : __libc_realloc(old, bytes); }

void* memalign(std::size_t alignment, std::size_t bytes) {
  return refuses_memory(bytes) ? nullptr : __libc_memalign(alignment, bytes);
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }

int posix_memalign(void** out, std::size_t alignment, std::size_t bytes) {
  void* const at = memalign(alignment, bytes);
  if (at == nullptr) return ENOMEM;
  *out = at;
  return 0;
}

}  // extern "C"
