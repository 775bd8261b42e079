#pragma once
/// A file of lines that several processes append to, and that is whole whenever it is looked at.

#include <sys/types.h>

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/descriptor.h"
#include "toolpace/base/result.h"

namespace toolpace::cli {

/// Lines are appended one at a time, under a lock of the file (flock) that others wait for. What a process that was killed left of a
/// line is cut off by the next one.
class ResultsFile {
 public:
  /// Made where it is not there yet. Errors: io, of file_error(); usage ("results-no-file") where it is no regular file.
  static Result<ResultsFile> open(const std::filesystem::path& file, std::stop_token stop);

  /// The whole lines that it has now, without their ends. Errors: io, cancelled.
  Result<std::vector<std::string>> lines() const;

  /// @param header  written before it where the file is empty
  /// @param line    with its end; all of it is written, or nothing
  /// Errors: io, cancelled.
  Result<void> append(std::string_view header, std::string_view line);

 private:
  ResultsFile(std::filesystem::path name, Descriptor descriptor, std::stop_token stop)
      : name_(std::move(name)), descriptor_(std::move(descriptor)), stop_(std::move(stop)) {}
  Result<void> lock() const;
  Result<std::string> content() const;
  Result<off_t> cut_to_whole() const;

  std::filesystem::path name_;
  Descriptor descriptor_;
  std::stop_token stop_;
};

}  // namespace toolpace::cli
