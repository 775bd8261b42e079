#pragma once
/// The texts that a program consists of: itself and the sub-program files it calls.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "toolpace/base/monitor.h"
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

/// What came of looking for the file of a sub-program: its index, or what kept it from being one.
struct FoundFile {
  std::optional<std::size_t> index = {};
  std::string trouble = {};  ///< of a file that is there and cannot be taken; a clause for people
  std::string remedy = {};
};

class ProgramFiles {
 public:
  /// @param folders  where sub-program files may lie; nothing else is ever opened
  /// @param monitor  cancels the reading of sub-program files
  ProgramFiles(std::string_view text, std::string name, std::vector<std::filesystem::path> folders,
               const Monitor& monitor);

  ProgramText& at(std::size_t file) { return *files_[file]; }
  std::size_t size() const { return files_.size(); }

  /// What reading every file once counts towards ReadLimits::lines.
  std::size_t work();

  /// Finds the file of sub-program `label` ("name" or a number).
  const FoundFile& find(const std::string& label, bool fanuc);

  /// The first sub-program file that could not be read: nothing is known of the program then.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  /// Names in a folder by what they are with their extension in small letters.
  using NamesBySmall = std::unordered_map<std::string, std::string>;

  FoundFile search(const std::string& label, bool fanuc);
  std::optional<std::filesystem::path> place_of(const std::filesystem::path& folder,
                                                const std::vector<std::string>& names);
  FoundFile open(const std::filesystem::path& path);
  const NamesBySmall& names_in(const std::filesystem::path& folder);
  bool lies_within(const std::filesystem::path& file) const;

  std::vector<std::unique_ptr<ProgramText>> files_;
  std::vector<std::filesystem::path> folders_;
  Monitor monitor_;
  std::optional<Error> failure_;
  std::unordered_map<std::string, FoundFile> known_;
  std::unordered_map<std::string, NamesBySmall> listings_;  ///< of the folders
};

}  // namespace toolpace::nc
