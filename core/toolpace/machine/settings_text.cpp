#include "toolpace/machine/settings_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace toolpace {
namespace {

constexpr int kIncludeDepth = 8;  // files within each other; a ring of them ends here

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_number(char c) { return is_decimal_digit(c) || c == '.' || c == '-' || c == '+'; }

std::size_t skip(std::string_view text, std::size_t at, bool (*is)(char)) {
  while (at < text.size() && is(text[at])) ++at;
  return at;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Where a part of the whole text begins.
std::optional<std::size_t> place_in(std::string_view whole, std::string_view part) {
  return static_cast<std::size_t>(part.data() - whole.data());
}

/// The last word of a line before its comment: the command of "echo:  G20    ; Units in inches".
std::string_view last_word(std::string_view line) {
  line = trimmed(line.substr(0, line.find(';')));
  const std::size_t before = line.find_last_of(" \t:");
  return before == std::string_view::npos ? line : line.substr(before + 1);
}

class IniReader {
 public:
  IniReader(std::string_view whole, const ReadIncluded& included) : whole_(whole), included_(included) {}

  /// @param outer  line of the outermost file that includes this text; 0 = this is that file
  void read(std::string_view text, std::size_t outer, int depth) {
    for_each_line(text, [&](std::string_view line, std::size_t number) { take(line, outer ? outer : number, depth); });
  }

  ImportedValues values;

 private:
  void take(std::string_view line, std::size_t number, int depth) {
    constexpr std::string_view kInclude = "#INCLUDE";
    if (line.starts_with(kInclude) && included_ && depth < kIncludeDepth) {
      for (const std::string& text : included_(trimmed(line.substr(kInclude.size())))) read(text, number, depth + 1);
      return;
    }
    if (line.empty() || line.front() == '#' || line.front() == ';') return;
    if (line.front() == '[') {
      section_ = upper(trimmed(line.substr(1, line.find(']') - 1)));
      return;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view value = trimmed(line.substr(equals + 1));
    const auto [known, is_new] = values.try_emplace(
        section_ + "." + upper(trimmed(line.substr(0, equals))),
        ImportedValue{std::string(value), number, depth == 0 ? place_in(whole_, value) : std::optional<std::size_t>()});
    if (!is_new && !known->second.again && known->second.text != value) known->second.again = number;
  }

  std::string_view whole_;
  const ReadIncluded& included_;
  std::string section_;
};

class KlipperReader {
 public:
  KlipperReader(std::string_view whole, const ReadIncluded& included) : whole_(whole), included_(included) {}

  void read(std::string_view text, std::size_t outer, int depth) {
    std::string section;
    for (std::size_t number = 1; !text.empty(); ++number) take(take_line(text), section, outer ? outer : number, depth);
  }

  /// The values of the file, with those of its SAVE_CONFIG block on top.
  ImportedValues finish() {
    for (auto& [key, value] : saved_) values_.insert_or_assign(key, std::move(value));
    return std::move(values_);
  }

 private:
  void take(std::string_view line, std::string& section, std::size_t number, int depth) {
    constexpr std::string_view kSaved = "#*#";
    const bool is_saved = line.starts_with(kSaved);
    if (is_saved) {
      line.remove_prefix(kSaved.size());
      if (line.starts_with(' ')) line.remove_prefix(1);
    }
    if (line.empty() || line.front() == ' ' || line.front() == '\t') return;  // goes on with the value before
    line = without_comment(line);
    if (line.empty()) return;
    if (line.front() == '[') {
      section = std::string(trimmed(line.substr(1, line.find(']') - 1)));
      if (!is_saved && !include(section, number, depth)) {
        values_.try_emplace(lower(section) + ".", ImportedValue{"", number});  // some have no keys
      }
      return;
    }
    const std::size_t mark = line.find_first_of(":=");
    if (mark == std::string_view::npos || section.empty()) return;
    const std::string_view value = trimmed(line.substr(mark + 1));
    (is_saved ? saved_ : values_)
        .insert_or_assign(lower(section) + "." + lower(trimmed(line.substr(0, mark))),
                          ImportedValue{std::string(value), number,
                                        depth == 0 ? place_in(whole_, value) : std::optional<std::size_t>()});
  }

  /// Whether the section is an [include …], which is followed here.
  bool include(const std::string& section, std::size_t number, int depth) {
    constexpr std::string_view kInclude = "include ";
    if (!section.starts_with(kInclude)) return false;
    if (!included_ || depth >= kIncludeDepth) return true;
    for (const std::string& text : included_(trimmed(std::string_view(section).substr(kInclude.size())))) {
      read(text, number, depth + 1);
    }
    return true;
  }

  static std::string_view without_comment(std::string_view line) {
    return trimmed(line.substr(0, line.find_first_of("#;")));
  }

  std::string_view whole_;
  const ReadIncluded& included_;
  ImportedValues values_, saved_;
};

}  // namespace

std::optional<MarlinWords> marlin_words_in(std::string_view line) {
  constexpr std::array<std::string_view, 6> kCodes = {"M92", "M201", "M203", "M204", "M205", "M900"};
  for (const std::string_view code : kCodes) {
    const std::size_t begin = line.find(code);
    if (begin == std::string_view::npos) continue;
    const std::size_t behind = begin + code.size();
    if (behind >= line.size() || line[behind] != ' ') continue;
    if (begin > 0 && line[begin - 1] != ' ' && line[begin - 1] != ':' && line[begin - 1] != '\t') continue;
    MarlinWords result{std::string(code), {}};
    std::string_view rest = line.substr(behind, line.find(';', behind) - behind);
    while (!(rest = trimmed(rest)).empty()) {
      const std::size_t end = skip(rest, 1, is_of_number);
      if (std::isupper(static_cast<unsigned char>(rest.front())) == 0 || end == 1) break;
      result.words.emplace_back(rest.front(), rest.substr(1, end - 1));
      rest.remove_prefix(end);
    }
    if (!result.words.empty()) return result;
  }
  return std::nullopt;
}

ImportedValues read_marlin_values(std::string_view text) {
  ImportedValues values;
  for_each_line(text, [&](std::string_view line, std::size_t number) {
    const std::string_view units = last_word(line);
    if (units == kInchesOfMarlin) values.insert_or_assign(std::string(units), ImportedValue{"", number});
    if (units == "G21") values.erase(std::string(kInchesOfMarlin));
    const auto command = marlin_words_in(line);
    if (!command) return;
    // "M203 T0 E25" of an extruder is none of an axis.
    for (const auto& [letter, value] : command->words) {
      values.insert_or_assign(command->code + " " + letter,
                              ImportedValue{std::string(value), number, place_in(text, value)});
    }
  });
  return values;
}

ImportedValues read_ini_values(std::string_view text, const ReadIncluded& included) {
  IniReader reader(text, included);
  reader.read(text, 0, 0);
  return std::move(reader.values);
}

ImportedValues read_klipper_values(std::string_view text, const ReadIncluded& included) {
  KlipperReader reader(text, included);
  reader.read(text, 0, 0);
  return reader.finish();
}

ImportedValues read_controller_values(std::string_view text, Controller controller, const ReadIncluded& included) {
  switch (controller) {
    case Controller::klipper: return read_klipper_values(text, included);
    case Controller::marlin: return read_marlin_values(text);
    case Controller::linuxcnc: return read_ini_values(text, included);
    default: return read_grbl_values(text);
  }
}

std::string key_in_values(const std::string& key, Controller controller) {
  if (!key.starts_with('[')) return key;
  const std::size_t end = key.find(']');
  const std::string joined = key.substr(1, end - 1) + "." + key.substr(end + 2);
  return controller == Controller::linuxcnc ? upper(joined) : joined;
}

}  // namespace toolpace
