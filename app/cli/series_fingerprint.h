#pragma once
/// What a row of a series was made of, in 16 digits.

#include <cstdint>
#include <string>
#include <vector>

#include "series.h"
#include "toolpace/base/monitor.h"

namespace toolpace::cli {

/// Grows with each thing that is put in (FNV-1a, 64 bits): the same things in the same order give the same digits, others others, but
/// for one chance in 2⁶⁴.
class Fingerprint {
 public:
  void add(std::string_view text);
  /// The content of a file. Errors: io, cancelled.
  Result<void> add_file(const std::string& file, const Monitor& monitor);
  std::string digits() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Of what all rows of a series share: the version of the program, the command, its flags but the names of outputs, and the files that
/// these name. Errors: io, cancelled.
Result<Fingerprint> fingerprint_of(const Series& series, const Monitor& monitor);

}  // namespace toolpace::cli
