/// The C library's calls for files, each of which can fail.

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>

#include "faults.h"

using namespace toolpace::test;

namespace {

/// What the call would be without this library.
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Where a struck call fails, errno says why.
bool fails(FaultCall call) {
  if (!fault_strikes(call)) return false;
  errno = fault_in_force().error;
  return true;
}

/// Only inputs shrink: a regular file that is open for reading alone.
bool is_input(int descriptor) {
  struct stat info {};
  static const auto look = next<int(int, struct stat*)>("fstat");
  return look(descriptor, &info) == 0 && S_ISREG(info.st_mode) && (fcntl(descriptor, F_GETFL) & O_ACCMODE) == O_RDONLY;
}

void halve(int descriptor) {
  struct stat info {};
  static const auto look = next<int(int, struct stat*)>("fstat");
  if (look(descriptor, &info) != 0) return;
  char link[40];
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", descriptor);
  if (truncate(link, info.st_size / 2) != 0) _exit(99);
}

/// A call about an open file: fails before it, or shrinks the file after it.
template <class Call>
auto struck(FaultCall call, int descriptor, Call&& make) -> decltype(make()) {
  if (!concerns_faults(descriptor)) return make();
  const bool shrinks = fault_in_force().deed == FaultDeed::shrink;
  if (shrinks) {
    const auto result = make();
    const int number = errno;
    if (is_input(descriptor) && fault_strikes(call)) halve(descriptor);
    errno = number;
    return result;
  }
  using Outcome = decltype(make());
  return fails(call) ? Outcome{-1} : make();
}

/// How many bytes of a write go through; 0 with errno set: none.
std::size_t admitted(int descriptor, std::size_t bytes) {
  if (!concerns_faults(descriptor)) return bytes;
  const std::size_t count = admitted_bytes(bytes);
  if (count == 0) errno = fault_in_force().error;
  return count;
}

int open_mode(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, int) : 0;
}

}  // namespace

// The 64-bit names are the same calls where a long has 64 bits.
extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = open_mode(flags, rest);
  va_end(rest);
  static const auto real = next<int(const char*, int, ...)>("open");
  return concerns_faults(path) && fails(kOpen) ? -1 : real(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = open_mode(flags, rest);
  va_end(rest);
  static const auto real = next<int(int, const char*, int, ...)>("openat");
  return (folder == AT_FDCWD || path[0] == '/') && concerns_faults(path) && fails(kOpen)
             ? -1
             : real(folder, path, flags, mode);
}

std::FILE* fopen(const char* path, const char* mode) {
  static const auto real = next<std::FILE*(const char*, const char*)>("fopen");
  return concerns_faults(path) && fails(kOpen) ? nullptr : real(path, mode);
}

int mkostemp(char* pattern, int flags) {
  static const auto real = next<int(char*, int)>("mkostemp");
  return concerns_faults(pattern) && fails(kOpen) ? -1 : real(pattern, flags);
}

ssize_t read(int descriptor, void* to, size_t bytes) {
  static const auto real = next<ssize_t(int, void*, size_t)>("read");
  return struck(kRead, descriptor, [&] { return real(descriptor, to, bytes); });
}

ssize_t pread(int descriptor, void* to, size_t bytes, off_t offset) {
  static const auto real = next<ssize_t(int, void*, size_t, off_t)>("pread");
  return struck(kRead, descriptor, [&] { return real(descriptor, to, bytes, offset); });
}

ssize_t write(int descriptor, const void* from, size_t bytes) {
  static const auto real = next<ssize_t(int, const void*, size_t)>("write");
  const std::size_t count = admitted(descriptor, bytes);
  return count == 0 && bytes > 0 ? -1 : real(descriptor, from, count);
}

ssize_t pwrite(int descriptor, const void* from, size_t bytes, off_t offset) {
  static const auto real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  const std::size_t count = admitted(descriptor, bytes);
  return count == 0 && bytes > 0 ? -1 : real(descriptor, from, count, offset);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
  static const auto real = next<ssize_t(int, const iovec*, int)>("writev");
  std::size_t bytes = 0;
  for (int i = 0; i < count; ++i) bytes += parts[i].iov_len;
  const std::size_t taken = admitted(descriptor, bytes);
  if (taken == bytes) return real(descriptor, parts, count);
  if (taken == 0) return -1;
  static const auto plain = next<ssize_t(int, const void*, size_t)>("write");
  for (int i = 0; i < count; ++i) {
    if (parts[i].iov_len > 0)
      return plain(descriptor, parts[i].iov_base, taken < parts[i].iov_len ? taken : parts[i].iov_len);
  }
  return 0;
}

int fsync(int descriptor) {
  static const auto real = next<int(int)>("fsync");
  return struck(kSync, descriptor, [&] { return real(descriptor); });
}

int fdatasync(int descriptor) {
  static const auto real = next<int(int)>("fdatasync");
  return struck(kSync, descriptor, [&] { return real(descriptor); });
}

int close(int descriptor) {
  static const auto real = next<int(int)>("close");
  const bool refused = concerns_faults(descriptor) && fault_strikes(kClose);
  const int code = real(descriptor);
  if (!refused) return code;
  errno = fault_in_force().error;
  return -1;
}

int rename(const char* from, const char* to) {
  static const auto real = next<int(const char*, const char*)>("rename");
  return concerns_faults(to) && fails(kRename) ? -1 : real(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  static const auto real = next<int(int, const char*, int, const char*, unsigned)>("renameat2");
  return concerns_faults(to) && fails(kRename) ? -1 : real(from_folder, from, to_folder, to, flags);
}

int link(const char* from, const char* to) {
  static const auto real = next<int(const char*, const char*)>("link");
  return concerns_faults(to) && fails(kRename) ? -1 : real(from, to);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
  static const auto real = next<int(int, const char*, int, const char*, int)>("linkat");
  return concerns_faults(to) && fails(kRename) ? -1 : real(from_folder, from, to_folder, to, flags);
}

int fstat(int descriptor, struct stat* info) {
  static const auto real = next<int(int, struct stat*)>("fstat");
  return struck(kLook, descriptor, [&] { return real(descriptor, info); });
}

int poll(pollfd* of, nfds_t count, int patience) {
  static const auto real = next<int(pollfd*, nfds_t, int)>("poll");
  return count > 0 && concerns_faults(of[0].fd) && fails(kWait) ? -1 : real(of, count, patience);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = open_mode(flags, rest);
  va_end(rest);
  return open(path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = open_mode(flags, rest);
  va_end(rest);
  return openat(folder, path, flags, mode);
}

int fstat64(int descriptor, struct stat64* info) { return fstat(descriptor, reinterpret_cast<struct stat*>(info)); }
std::FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }
int mkostemp64(char* pattern, int flags) { return mkostemp(pattern, flags); }
ssize_t pread64(int descriptor, void* to, size_t bytes, off64_t offset) { return pread(descriptor, to, bytes, offset); }
ssize_t pwrite64(int descriptor, const void* from, size_t bytes, off64_t offset) {
  return pwrite(descriptor, from, bytes, offset);
}

}  // extern "C"
