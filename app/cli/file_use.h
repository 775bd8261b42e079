#pragma once
/// The files that a command is told to read and to write.

#include <string>
#include <vector>

#include "toolpace/base/result.h"

namespace toolpace::cli {

/// Filled while a command adds its flags, asked when they are read. The names are looked at then, so they have to live on.
class FileUse {
 public:
  /// @param what  the file as messages name it: "the machine file", "--setpoints"
  void reads(std::string what, const std::string& file) { inputs_.push_back({std::move(what), &file}); }
  void writes(std::string what, const std::string& file) { outputs_.push_back({std::move(what), &file}); }
  /// @param wanted  whether standard output is to be one JSON object
  void prints_json(const bool& wanted) { json_ = &wanted; }

  /// Errors (usage): an output that is an input ("output-is-input") or another output ("output-twice", "two-outputs").
  /// Standard output is one, too.
  /// @param sub_programs  files that the program made known
  Result<void> check(const std::vector<std::string>& sub_programs = {}) const;

 private:
  struct Named {
    std::string what;
    const std::string* file;
  };
  std::vector<Named> inputs_, outputs_;
  const bool* json_ = nullptr;
};

}  // namespace toolpace::cli
