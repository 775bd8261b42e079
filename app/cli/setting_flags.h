#pragma once
/// A setup as the flags that make it of another one.

#include <string>
#include <vector>

#include "job_flags.h"
#include "json.h"

namespace toolpace::cli {

/// A flag and its value, a number or a word.
struct SettingFlag {
  std::string flag;
  Json value;
  std::string text;  ///< the value as it is typed
};

/// The flags with which a command that was given `given`, and so has the setup `from`, has the setup `to`, as far as law, limits along
/// the path, look-ahead and corners go: those that were given and those that change something. Numbers read back to the same bits.
std::vector<SettingFlag> setting_flags(const JobFlags& given, const Setup& from, const Setup& to);

/// {"--am": 1500, "--law": "seven-phase", …}
Json to_json(const std::vector<SettingFlag>& flags);
/// "--am 1500 --law seven-phase"
std::string to_text(const std::vector<SettingFlag>& flags);

}  // namespace toolpace::cli
