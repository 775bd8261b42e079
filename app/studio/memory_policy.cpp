#include "memory_policy.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace toolpace::studio {

void keep_memory_between_plans() {
#ifdef __GLIBC__
  constexpr int kMiB = 1 << 20;
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, 32 * kMiB);  // bigger ones, of programs of a million blocks, are given back at once
  mallopt(M_TRIM_THRESHOLD, 128 * kMiB);
#endif
}

}  // namespace toolpace::studio
