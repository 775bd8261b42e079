#pragma once
/// Makes calls of the process that it is loaded into fail on purpose: files that cannot be opened, read, written, synced
/// or renamed, disks that fill up, signals that interrupt, inputs that shrink, memory that is not there.
///
/// A program is preloaded with it (LD_PRELOAD) and told by its environment, from main() until main() returns:
///   TOOLPACE_FAULT         KIND:AT, a name of kFaultKinds and a number
///   TOOLPACE_FAULT_FOLDER  only files below it are touched (and standard input, where it is read)
///   TOOLPACE_FAULT_TALLY   file of 64-bit numbers, the Tally, kept up to date
/// or it links it and calls arm_faults() around what it wants to see fail. Works where the C library is glibc.

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace toolpace::test {

/// What is counted and struck. Calls that are no business of the program (the loader's, other files') are neither.
enum FaultCall : unsigned {
  kOpen = 1U << 0U,      ///< opens files and makes temporaries
  kRead = 1U << 1U,      ///< read, pread
  kWrite = 1U << 2U,     ///< write, pwrite, writev
  kSync = 1U << 3U,      ///< fsync, fdatasync
  kClose = 1U << 4U,     ///< the file is closed all the same
  kRename = 1U << 5U,    ///< rename, link
  kLook = 1U << 6U,      ///< fstat
  kWait = 1U << 7U,      ///< poll
  kAllocate = 1U << 8U,  ///< malloc and its kin, operator new among them
};

enum class FaultTurn : std::uint8_t {
  once,    ///< the AT-th call alone
  onward,  ///< the AT-th and all that follow
  every,   ///< each AT-th
  bytes,   ///< there is room for AT − 1 bytes
};

enum class FaultDeed : std::uint8_t {
  fail,     ///< with `error`
  shorten,  ///< half of the bytes are taken
  shrink,   ///< the call succeeds, and then the file loses its second half
};

struct FaultKind {
  const char* name;
  unsigned calls;  ///< of FaultCall
  FaultTurn turn;
  FaultDeed deed;
  int error;  ///< errno of a failing call
};

/// The kinds, by name; null for a name that is none.
const FaultKind* fault_kind(const char* name);

struct Tally {
  std::atomic<std::uint64_t> calls;     ///< that the kind is about; of FaultTurn::bytes, bytes
  std::atomic<std::uint64_t> injected;  ///< faults
  /// All calls, by the bit of FaultCall, and last of all the bytes that were to be written: one run without faults tells
  /// how often each kind could strike.
  std::atomic<std::uint64_t> seen[10];
};

struct FaultScope {
  const char* folder = nullptr;      ///< files below it
  bool workers_only = false;         ///< spare the main thread
  std::size_t least_allocation = 0;  ///< spare smaller ones [bytes]
};

/// From now on calls of this kind are counted, and fail from `at`; at = 0 only counts. The tally starts at 0.
void arm_faults(const FaultKind& kind, std::uint64_t at, const FaultScope& scope);
/// @return what was counted; it stays readable until the next arm_faults()
const Tally& disarm_faults();

// For the replaced calls.

/// Counts a call and says whether it is to be struck.
bool fault_strikes(FaultCall call);
/// Counts an allocation and says whether it is to be refused. Safe before anything is initialised.
bool refuses_memory(std::size_t bytes);
/// The kind in force; only of use where fault_strikes() said so.
const FaultKind& fault_in_force();
/// Counts bytes to be written. @return how many of them are to be taken; `bytes` where nothing is to be struck
std::size_t admitted_bytes(std::size_t bytes);
bool concerns_faults(int descriptor);
bool concerns_faults(const char* path);

}  // namespace toolpace::test
