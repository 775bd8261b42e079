#pragma once
/// Keeps what is read apart from what is written, so that no work loses the files it began with.

#include <filesystem>
#include <string>
#include <vector>

#include "toolpace/base/result.h"

namespace toolpace {

/// A file and the part it plays in a piece of work.
struct FileRole {
  std::string what;            ///< as messages name it: "the program", "--setpoints"
  std::filesystem::path file;  ///< "-" = standard input or output; empty = there is none
};

/// To be asked before anything is written, and again when more inputs are known. Files are the same whatever links lead
/// to them. Errors: usage: output-is-input; output-twice, where two outputs are one file.
Result<void> check_outputs(const std::vector<FileRole>& outputs, const std::vector<FileRole>& inputs);

}  // namespace toolpace
