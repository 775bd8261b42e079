#pragma once
/// Files with a name for the time until they take the place of another one.

#include <filesystem>

#include "toolpace/base/descriptor.h"
#include "toolpace/base/result.h"

namespace toolpace {

/// A file beside `target`, held by a lock for as long as it is open. What dies with it (kill -9, power) is swept away when
/// the next one is made in that folder; the lock tells the dead from the living, whatever their process numbers.
struct TemporaryFile {
  std::filesystem::path name;
  Descriptor descriptor;

  /// Errors: io, of file_error(), about `target`.
  static Result<TemporaryFile> create_beside(const std::filesystem::path& target);
};

}  // namespace toolpace
