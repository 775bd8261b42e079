#include "faults.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

namespace toolpace::test {
namespace {

constexpr std::size_t kBytesSeen = 9;  // of Tally::seen
constexpr unsigned kInterruptible = kOpen | kRead | kWrite | kSync | kWait;

constexpr std::array kFaultKinds = {
    FaultKind{"short-write", kWrite, FaultTurn::every, FaultDeed::shorten, 0},
    FaultKind{"disk-full", kWrite, FaultTurn::bytes, FaultDeed::fail, ENOSPC},
    FaultKind{"interrupted-once", kInterruptible, FaultTurn::once, FaultDeed::fail, EINTR},
    FaultKind{"interrupted-often", kInterruptible, FaultTurn::every, FaultDeed::fail, EINTR},
    FaultKind{"open-error", kOpen, FaultTurn::once, FaultDeed::fail, EMFILE},
    FaultKind{"read-error", kRead, FaultTurn::once, FaultDeed::fail, EIO},
    FaultKind{"sync-error", kSync, FaultTurn::once, FaultDeed::fail, EIO},
    FaultKind{"close-error", kClose, FaultTurn::once, FaultDeed::fail, EIO},
    FaultKind{"rename-error", kRename, FaultTurn::once, FaultDeed::fail, EIO},
    FaultKind{"shrinking-input", kRead | kLook, FaultTurn::once, FaultDeed::shrink, 0},
    FaultKind{"memory-once", kAllocate, FaultTurn::once, FaultDeed::fail, ENOMEM},
    FaultKind{"memory-out", kAllocate, FaultTurn::onward, FaultDeed::fail, ENOMEM},
};

std::atomic<bool> armed = false;
const FaultKind* kind = nullptr;
std::uint64_t first = 0;
FaultScope scope;
bool begins_inside = false;  // relative names are below the folder
Tally own_tally;
Tally* tally = &own_tally;

bool is_below(const char* path, const char* folder) {
  const std::size_t length = std::strlen(folder);
  return std::strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

bool is_due(std::uint64_t number) {
  if (first == 0) return false;
  switch (kind->turn) {
    case FaultTurn::once: return number == first;
    case FaultTurn::onward: return number >= first;
    case FaultTurn::every: return number % first == 0;
    case FaultTurn::bytes: break;
  }
  return false;
}

/// Nothing here may allocate.
bool is_watched(FaultCall call) {
  if (!armed.load(std::memory_order_acquire)) return false;
  tally->seen[std::countr_zero(static_cast<unsigned>(call))].fetch_add(1);
  if ((kind->calls & call) == 0) return false;
  return !scope.workers_only || syscall(SYS_gettid) != getpid();
}

bool strikes_next() {
  const bool due = is_due(tally->calls.fetch_add(1) + 1);
  if (due) tally->injected.fetch_add(1);
  return due;
}

/// Shared with whoever asked, so that it is right however the process ends.
void share_tally(const char* file) {
  const int descriptor = ::open(file, O_RDWR | O_CLOEXEC);
  if (descriptor < 0 || ftruncate(descriptor, sizeof(Tally)) != 0) _exit(99);
  void* const at = mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (at == MAP_FAILED) _exit(99);
  tally = static_cast<Tally*>(at);
  close(descriptor);
}

void arm_from_environment() {
  const char* const wanted = std::getenv("TOOLPACE_FAULT");
  const char* const colon = wanted != nullptr ? std::strchr(wanted, ':') : nullptr;
  if (colon == nullptr) return;
  std::array<char, 64> name = {};
  std::memcpy(name.data(), wanted, std::min<std::size_t>(static_cast<std::size_t>(colon - wanted), name.size() - 1));
  const FaultKind* const named = fault_kind(name.data());
  if (named == nullptr) _exit(99);
  if (const char* const file = std::getenv("TOOLPACE_FAULT_TALLY")) share_tally(file);
  arm_faults(*named, std::strtoull(colon + 1, nullptr, 10), {std::getenv("TOOLPACE_FAULT_FOLDER")});
}

using Main = int (*)(int, char**, char**);
Main real_main = nullptr;

int main_under_faults(int argc, char** argv, char** environment) {
  arm_from_environment();
  const int code = real_main(argc, argv, environment);
  disarm_faults();
  return code;
}

}  // namespace

const FaultKind* fault_kind(const char* name) {
  const auto* const found = std::find_if(kFaultKinds.begin(), kFaultKinds.end(),
                                         [name](const FaultKind& k) { return std::strcmp(k.name, name) == 0; });
  return found == kFaultKinds.end() ? nullptr : found;
}

void arm_faults(const FaultKind& wanted, std::uint64_t at, const FaultScope& where) {
  disarm_faults();
  kind = &wanted;
  first = at;
  scope = where;
  std::array<char, PATH_MAX> here;
  begins_inside =
      scope.folder != nullptr && getcwd(here.data(), here.size()) != nullptr && is_below(here.data(), scope.folder);
  tally->calls = 0;
  tally->injected = 0;
  for (auto& count : tally->seen) count = 0;
  armed.store(true, std::memory_order_release);
}

const Tally& disarm_faults() {
  armed.store(false, std::memory_order_release);
  return *tally;
}

bool fault_strikes(FaultCall call) { return is_watched(call) && strikes_next(); }

bool refuses_memory(std::size_t bytes) {
  if (!is_watched(kAllocate) || bytes < scope.least_allocation || !strikes_next()) return false;
  errno = ENOMEM;
  return true;
}

const FaultKind& fault_in_force() { return *kind; }

std::size_t admitted_bytes(std::size_t bytes) {
  const bool watched = is_watched(kWrite);
  if (armed.load(std::memory_order_acquire)) tally->seen[kBytesSeen].fetch_add(bytes);
  if (!watched || bytes == 0) return bytes;
  if (kind->turn != FaultTurn::bytes) {
    if (!strikes_next()) return bytes;
    return kind->deed == FaultDeed::shorten ? std::max<std::size_t>(bytes / 2, 1) : 0;
  }
  const std::uint64_t before = tally->calls.fetch_add(bytes);
  if (first == 0 || before + bytes < first) return bytes;
  tally->injected.fetch_add(1);
  return before + 1 < first ? static_cast<std::size_t>(first - 1 - before) : 0;
}

bool concerns_faults(int descriptor) {
  if (!armed.load(std::memory_order_acquire) || scope.folder == nullptr) return false;
  if (descriptor == STDIN_FILENO) return true;
  std::array<char, 40> link = {"/proc/self/fd/"};
  char digits[12];
  int count = 0;
  for (int rest = descriptor; rest > 0 || count == 0; rest /= 10) digits[count++] = static_cast<char>('0' + rest % 10);
  for (char* out = link.data() + std::strlen(link.data()); count > 0;) *out++ = digits[--count];
  std::array<char, PATH_MAX> target;
  const ssize_t length = readlink(link.data(), target.data(), target.size() - 1);
  if (length <= 0) return false;
  target[static_cast<std::size_t>(length)] = '\0';
  return is_below(target.data(), scope.folder);
}

bool concerns_faults(const char* path) {
  if (!armed.load(std::memory_order_acquire) || scope.folder == nullptr) return false;
  return path[0] == '/' ? is_below(path, scope.folder) : begins_inside;
}

}  // namespace toolpace::test

/// The C library's own, so that faults begin with main() and spare the loader and static initialisers.
extern "C" int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(),
                                 void (*fini)(), void (*loader_fini)(), void* stack_end) {
  using Start = int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  toolpace::test::real_main = main;
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(toolpace::test::main_under_faults, argc, argv, init, fini, loader_fini, stack_end);
}
