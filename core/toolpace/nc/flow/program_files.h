#pragma once
/// The texts that a program consists of: itself and the sub-program files it calls.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "toolpace/nc/flow/flow_index.h"

namespace toolpace::nc {

inline constexpr std::size_t kLengthOfALine = 16;  ///< [bytes] longer lines count as several in ReadLimits::lines

struct ProgramText {
  std::string name;     ///< shown in diagnostics
  std::string storage;  ///< the text of a sub-program file
  std::string_view text;
  std::optional<std::size_t> work;  ///< what reading it once counts
  std::unique_ptr<FlowIndex> index;

  FlowIndex& flow(bool fanuc) {
    if (!index) index = std::make_unique<FlowIndex>(text, fanuc);
    return *index;
  }
};

class ProgramFiles {
 public:
  /// @param folders  where sub-program files may lie; nothing else is ever opened
  ProgramFiles(std::string_view text, std::string name, std::vector<std::filesystem::path> folders);

  ProgramText& at(std::size_t file) { return *files_[file]; }
  std::size_t size() const { return files_.size(); }

  /// What reading every file once counts towards ReadLimits::lines.
  std::size_t work();

  /// Finds the file of sub-program `label` ("name" or a number).
  /// @return its index, or none
  std::optional<std::size_t> find(const std::string& label, bool fanuc);

 private:
  std::optional<std::size_t> open(const std::filesystem::path& folder, const std::string& name);

  std::vector<std::unique_ptr<ProgramText>> files_;
  std::vector<std::filesystem::path> folders_;
  std::unordered_map<std::string, std::optional<std::size_t>> known_;
};

}  // namespace toolpace::nc
