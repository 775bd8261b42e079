#include "toolpace/controller/program_text.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "toolpace/base/numbers.h"

namespace toolpace {
namespace {

constexpr std::size_t kLongestLine = 0xFFFF;

/// A code in tenths: 431 for 43.1. Moves `at` behind it.
int code_in_tenths(std::string_view line, std::size_t& at) {
  constexpr int kMostCode = 100000;
  const auto is_digit_at = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  while (at < line.size() && line[at] == ' ') ++at;
  int code = 0;
  for (; is_digit_at(at); ++at) code = std::min(code * 10 + (line[at] - '0'), kMostCode);
  code *= 10;
  if (at < line.size() && line[at] == '.' && is_digit_at(at + 1)) {
    code += line[at + 1] - '0';
    at += 2;
  }
  return code;
}

std::uint8_t bits_of_m(int code) {
  if (code == 30 || code == 40 || code == 50) return kSpindleCode;
  if (code >= 70 && code <= 90 && code % 10 == 0) return kCoolantCode;
  return static_cast<std::uint8_t>(code == 4000 ? kFinishCode : 0);
}

std::uint8_t bits_of_g(int code) {
  if (code >= 540 && code <= 599) return kOffsetCode;
  if (code == 610 || code == 611 || code == 640) return kPathCode;
  const bool moves_the_origin =
      code == 100 || code == 280 || code == 300 || code == 431 || (code >= 920 && code <= 923);
  return static_cast<std::uint8_t>(moves_the_origin ? kOriginCode : 0);
}

std::uint8_t codes_of(std::string_view line) {
  std::uint8_t bits = 0;
  for (std::size_t i = 0; i < line.size();) {
    const char c = line[i++];
    if (c == ';') break;
    if (c == '(') {
      i = std::min(line.find(')', i), line.size());
    } else if (c == 'G' || c == 'g') {
      bits = static_cast<std::uint8_t>(bits | bits_of_g(code_in_tenths(line, i)));
    } else if (c == 'M' || c == 'm') {
      bits = static_cast<std::uint8_t>(bits | bits_of_m(code_in_tenths(line, i)));
    } else if (c == 'S' || c == 's') {
      bits |= kSpindleCode;
    } else if (c == 'E' || c == 'e') {
      bits |= kExtruderWord;
    }
  }
  return bits;
}

/// Follows E through a program.
class ExtruderScan {
 public:
  /// @return how much a line feeds [mm]
  double run(std::string_view line) {
    std::optional<double> e;
    bool sets_origin = false;
    for (std::size_t i = 0; i < line.size();) {
      const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(line[i++])));
      if (c == ';') break;
      if (c == '(') {
        i = std::min(line.find(')', i), line.size());
      } else if (c == 'G') {
        const int code = code_in_tenths(line, i);
        if (code == 200 || code == 210) unit_ = code == 200 ? 25.4 : 1.0;
        if (code == 900 || code == 910) is_relative_ = code == 910;
        sets_origin = sets_origin || code == 920;
      } else if (c == 'M') {
        const int code = code_in_tenths(line, i);
        if (code == 820 || code == 830) has_relative_e_ = code == 830;
      } else if (c == 'E') {
        const std::size_t end = std::min(line.find_first_not_of("0123456789.+-", i), line.size());
        e = parse_number(line.substr(i, end - i));
        i = end;
      }
    }
    if (!e) return 0;
    const double value = *e * unit_;
    const double fed = sets_origin ? 0.0 : is_relative_ || has_relative_e_ ? value : value - position_;
    position_ = sets_origin ? value : position_ + fed;
    return fed;
  }

 private:
  double position_ = 0, unit_ = 1;
  bool is_relative_ = false, has_relative_e_ = false;
};

void scan_extruder(std::string_view text, ProgramText& result) {
  ExtruderScan scan;
  result.extrusion.reserve(result.lines());
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    result.extrusion.push_back(static_cast<float>(scan.run(text.substr(0, end + 1))));
    text.remove_prefix(end + 1);
  }
}

}  // namespace

ProgramText scan_program(std::string_view text) {
  ProgramText result;
  const std::string_view all = text;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
    result.bytes.push_back(static_cast<std::uint16_t>(std::min(size, kLongestLine)));
    result.codes.push_back(codes_of(text.substr(0, size)));
    result.all_codes |= result.codes.back();
    text.remove_prefix(size);
  }
  if ((result.all_codes & kExtruderWord) != 0) scan_extruder(all, result);
  return result;
}

}  // namespace toolpace
