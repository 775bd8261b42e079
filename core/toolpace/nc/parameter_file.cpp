#include "toolpace/nc/parameter_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace toolpace::nc {
namespace {

std::string_view take_field(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  line.remove_prefix(begin);
  const std::size_t length = std::min(line.find_first_of(" \t\r"), line.size());
  const std::string_view field = line.substr(0, length);
  line.remove_prefix(length);
  return field;
}

template <class T>
bool parse(std::string_view field, T& value) {
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  return result.ec == std::errc() && result.ptr == field.data() + field.size();
}

}  // namespace

void read_parameter_file(std::string_view text, Parameters& parameters,
                         const std::function<void(std::size_t line, Fault)>& on_fault) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    const std::string_view first = take_field(line);
    if (first.empty() || first.front() == '#' || first.front() == ';') continue;
    const std::string_view second = take_field(line);
    int index = 0;
    double value = 0.0;
    if (!parse(first, index) || !parse(second, value) || !std::isfinite(value) || index < 1 ||
        index >= parameters.count()) {
      on_fault(number, {"parameter-file-line", "this is no line of a parameter file",
                        "a line is a parameter number and a value", 1, Severity::error});
      continue;
    }
    parameters.set_numbered(index, value);
  }
}

}  // namespace toolpace::nc
