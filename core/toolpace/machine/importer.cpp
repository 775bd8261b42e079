#include "toolpace/machine/importer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace {
namespace {

constexpr std::size_t kShown = 40;  // letters of a value in a message

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

const ImportedValue* Importer::find(std::string_view key) const {
  const auto at = values_.find(key);
  return at == values_.end() ? nullptr : &at->second;
}

std::optional<double> Importer::take(std::string_view key, double unit) {
  const ImportedValue* value = find(key);
  if (!value || error_) return std::nullopt;
  // A comment may stand behind the number.
  const std::string_view word = std::string_view(value->text).substr(0, value->text.find_first_of(" \t;#("));
  const auto number = parse_number(word);
  ++taken_;
  last_key_ = key;
  last_line_ = value->line;
  if (number) return *number * unit;
  fail(fmt::format("{} is '{}', which is no number", key, value->text.substr(0, kShown)));
  return std::nullopt;
}

void Importer::take(const std::string& section, const std::string& key, std::initializer_list<std::string_view> keys,
                    double unit, std::optional<double> none) {
  const auto there = std::find_if(keys.begin(), keys.end(), [&](std::string_view k) { return find(k) != nullptr; });
  if (there == keys.end()) return;
  const auto value = take(*there, unit);
  if (value && value != none) put(section, key, *value);
}

void Importer::put(const std::string& section, const std::string& key, double value) {
  if (error_) return;
  const NumberKey number = find_number(setup_, section, key);
  if (!is_in_range(value, number.range) || std::isinf(value)) {
    NumberRange finite = number.range;
    finite.may_be_infinite = false;
    return fail(fmt::format("{} makes {} {}, but it must be {}", last_key_, key, to_text(value), range_text(finite)));
  }
  *number.value = value * number.unit;
}

void Importer::set_travel(std::size_t axis, double low, double high) {
  if (error_) return;
  const std::string section = std::string("axes.") + kAxisNames[axis];
  for (const SetupSection& known : setup_sections(setup_)) {
    if (known.name != section) continue;
    const RangeKey& travel = known.ranges.front();
    *travel.low = low * travel.unit;
    *travel.high = high * travel.unit;
    if (is_ordered(travel)) continue;
    fail(fmt::format("{} makes {} [{}, {}], but it must be {}", last_key_, travel.name, to_text(low), to_text(high),
                     range_text(travel)));
  }
}

void Importer::refuse(std::string_view key, std::string_view must_be) {
  const ImportedValue* value = find(key);
  last_line_ = value->line;
  fail(fmt::format("{} is '{}', but it must be {}", key, value->text.substr(0, kShown), must_be));
}

void Importer::warn(std::string code, std::string message, std::string remedy, std::size_t line) {
  setup_.warnings.push_back(
      {Severity::warning, std::move(code), std::move(message), std::move(remedy), {name_, line, 0}, {}});
}

Result<Setup> Importer::finish(const char* what) {
  if (error_) return tl::unexpected(*error_);
  if (taken_ == 0 && setup_.warnings.empty()) {
    return tl::unexpected(Error{ErrorKind::input,
                                "import-empty",
                                std::string("no limits found: this does not look like ") + what,
                                "choose another file",
                                {name_, 0, 0},
                                {}});
  }
  PathLimits& path = setup_.machine.path;
  path.deceleration = path.acceleration;
  path.jerk_deceleration = path.jerk;
  const auto& axes = setup_.machine.axes;
  const bool has_jerk = std::isfinite(path.jerk) || std::any_of(axes.begin(), axes.end(), [](const AxisLimits& axis) {
                          return std::isfinite(axis.jerk);
                        });
  if (!has_jerk) setup_.options.law = LawKind::trapezoid;
  if (auto fine = check_setup(setup_.machine, setup_.options); !fine) return tl::unexpected(fine.error());
  return setup_;
}

void Importer::fail(std::string message) {
  if (error_) return;
  error_ = Error{ErrorKind::usage,       "import-value",
                 std::move(message),     "correct the controller's settings",
                 {name_, last_line_, 0}, {}};
}

}  // namespace toolpace
