#pragma once
/// Files that a settings file includes: printer.cfg by patterns, LinuxCNC's .ini by names.

#include <filesystem>
#include <optional>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/machine/settings_text.h"

namespace toolpace {

/// Reads them, relative to the folder of the file that a person named. The first one that cannot be read is kept as an error.
class IncludedFiles {
 public:
  IncludedFiles(const std::filesystem::path& file, const Monitor& monitor)
      : folder_(file.parent_path()), monitor_(monitor) {}

  /// @pre this object lives longer
  ReadIncluded reader();
  const std::optional<Error>& error() const { return error_; }

 private:
  std::vector<std::string> read(std::string_view name);

  std::filesystem::path folder_;
  const Monitor& monitor_;
  std::optional<Error> error_;
};

}  // namespace toolpace
