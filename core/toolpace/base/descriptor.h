#pragma once
/// Open files of the system, and waiting for them so that work which is cancelled ends.

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string_view>

#include "toolpace/base/result.h"

namespace toolpace {

/// An open file of the system. What the process was started with (standard input, a descriptor that a path names) is
/// lent and stays open.
class Descriptor {
 public:
  Descriptor() = default;
  static Descriptor owned(int value) { return {value, true}; }
  static Descriptor lent(int value) { return {value, false}; }
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { close(); }

  int value() const { return value_; }
  /// @return 0 or errno, which some file systems set to "disk full" only here
  int close();

 private:
  Descriptor(int value, bool is_owned) : value_(value), is_owned_(is_owned) {}
  int value_ = -1;
  bool is_owned_ = false;
};

/// The open descriptor of this process that a path names: "/dev/stdin", "/dev/fd/3", "/proc/self/fd/3", links to them.
/// Opening such a path anew would lose its place in the file, and does not work at all for sockets.
std::optional<int> named_descriptor(const std::filesystem::path& file);

/// "-" and names of descriptor 1.
bool is_standard_output(const std::filesystem::path& file);

/// Opens a file for reading; "-" = standard input. A FIFO is opened at once, whether it has a writer or not.
/// Errors: io, of file_error().
Result<Descriptor> open_for_reading(const std::filesystem::path& file);

/// Opens what exists for writing; "-" = standard output. Waits for the reader of a FIFO until it is there.
/// Errors: io, of file_error(); cancelled.
Result<Descriptor> open_for_writing(const std::filesystem::path& file, const std::stop_token& stop);

/// Waits until the descriptor can be read (written), or a moment or a signal has come, after which a stop token is to be
/// looked at. @return whether it can
bool wait_to_read(int descriptor);
bool wait_to_write(int descriptor);

/// Writes all of `bytes`, whatever the system takes at a time.
/// @return 0, errno, or ECANCELED when it was stopped
int write_fully(int descriptor, std::string_view bytes, const std::stop_token& stop);
/// The same at a place in the file.
int write_fully_at(int descriptor, std::string_view bytes, std::uint64_t offset, const std::stop_token& stop);

}  // namespace toolpace
