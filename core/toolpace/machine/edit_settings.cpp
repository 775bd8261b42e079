#include "toolpace/machine/edit_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/base/axis_unit.h"
#include "toolpace/base/numbers.h"
#include "toolpace/machine/joint_axes.h"
#include "toolpace/machine/startup_code.h"

namespace toolpace {
namespace {

constexpr double kRounding = 1e-9;  // relative, of a value that went through the file's unit

constexpr std::string_view kBlendTolerance = "G64 P", kStartupCode = "RS274NGC.RS274NGC_STARTUP_CODE";

/// Where a parameter stands.
struct Home {
  std::vector<std::string> keys;  ///< among the values of the text; more than one for joints that move an axis together
  double size = 1;                ///< of a unit of the file in units of the parameter
  std::size_t at = 0;             ///< of the number in the value's text
  std::size_t length = 0;         ///< of it; 0 = up to what stands behind a value
};

Error unwritable(const std::string& name, std::string message) {
  return {
      ErrorKind::usage, "settings-unwritable", std::move(message), "change it in the file by hand", {name, 0, 0}, {}};
}

/// The number without what stands behind it.
std::string_view number_in(const std::string& text) {
  return std::string_view(text).substr(0, text.find_first_of(" \t;#("));
}

/// With as many decimals as the number that it replaces, where they are enough for it.
std::string number_like(std::string_view before, double value) {
  const std::size_t dot = before.find('.');
  if (dot == std::string_view::npos || before.find_first_of("eE") != std::string_view::npos) return to_text(value);
  const std::string text = fmt::format("{:.{}f}", value, before.size() - dot - 1);
  return parse_number(text) == value ? text : to_text(value);
}

std::string newline_of(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

std::size_t end_of_line(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string_view::npos ? text.size() : end + 1;
}

class SettingEditor {
 public:
  SettingEditor(std::string_view text, const std::string& name, Controller controller, const ReadIncluded& included)
      : text_(text),
        name_(name),
        controller_(controller),
        included_(included),
        newline_(newline_of(text)),
        values_(read_controller_values(text, controller, included)) {}

  Result<std::string> set(const ControllerParameter& parameter, double value) {
    const Home home = home_of(parameter);
    const double number = rounded(value / home.size, home.size);
    if (!values_.contains(home.keys.front())) return insert(parameter, home.keys.front(), number);
    std::string out(text_);
    // From the end, so that places before stay where they are.
    std::vector<const ImportedValue*> places;
    for (const std::string& key : home.keys) places.push_back(&values_.find(key)->second);
    std::sort(places.begin(), places.end(), [](const auto* a, const auto* b) { return a->at > b->at; });
    for (const ImportedValue* place : places) {
      if (!place->at) return tl::unexpected(included(parameter, *place));
      const std::string_view old =
          home.length > 0 ? std::string_view(place->text).substr(home.at, home.length) : number_in(place->text);
      out.replace(*place->at + home.at, old.size(), number_like(old, number));
    }
    return out;
  }

  /// Whether `now` says the same as the text but for these keys.
  bool is_all_else_the_same(std::string_view now, const ControllerParameter& parameter) const {
    const std::vector<std::string> keys = home_of(parameter).keys;
    ImportedValues before = values_, after = read_controller_values(now, controller_, included_);
    for (const std::string& key : keys) {
      before.erase(key);
      after.erase(key);
    }
    std::erase_if(before, [](const auto& v) { return v.first.ends_with('.'); });  // sections
    std::erase_if(after, [](const auto& v) { return v.first.ends_with('.'); });
    return std::equal(before.begin(), before.end(), after.begin(), after.end(), [](const auto& a, const auto& b) {
      return a.first == b.first && a.second.text == b.second.text;
    });
  }

 private:
  Home home_of(const ControllerParameter& parameter) const {
    const std::string key = key_in_values(parameter.key, controller_);
    if (controller_ != Controller::linuxcnc) return {{key}, 1.0};
    if (parameter.key == kBlendTolerance) {
      const auto code = values_.find(kStartupCode);
      const StartupCode told = read_startup_code(code == values_.end() ? "" : code->second.text);
      return {{std::string(kStartupCode)}, told.unit, told.at, told.length};
    }
    Importer importer(values_, name_);
    const double length = length_unit(importer);
    if (key == kPathVelocityKeys[0]) {
      const auto there = std::find_if(kPathVelocityKeys.begin(), kPathVelocityKeys.end(),
                                      [&](std::string_view k) { return importer.find(k) != nullptr; });
      return {{std::string(there == kPathVelocityKeys.end() ? kPathVelocityKeys[0] : *there)}, length};
    }
    constexpr std::string_view kAxis = "AXIS_";
    if (!key.starts_with(kAxis)) return {{key}, 1.0};
    const auto axis = static_cast<std::size_t>(std::find(kAxisNames.begin(), kAxisNames.end(), key[kAxis.size()]) -
                                               kAxisNames.begin());
    auto keys = keys_of_axis(importer, joint_axes(importer), axis, key.substr(kAxis.size() + 1));
    if (keys.empty()) keys.push_back(key);
    return {std::move(keys), is_rotary(axis) ? 1.0 : length};
  }

  /// 30 mm/s are 1.1811023622047245 inch/s; what a person typed in millimetres is no longer round, but 25.4 mm/s are 1.
  static double rounded(double number, double size) {
    if (size == 1.0 || number == 0) return number;
    constexpr int kDigits = 12;
    const double scale = std::pow(10.0, kDigits - std::ceil(std::log10(std::abs(number))));
    return std::round(number * scale) / scale;
  }

  Error included(const ControllerParameter& parameter, const ImportedValue& place) const {
    return {ErrorKind::usage,
            "settings-included",
            fmt::format("{} stands in a file that line {} includes", parameter.key, place.line),
            "change it in that file",
            {name_, place.line, 0},
            {}};
  }

  Result<std::string> insert(const ControllerParameter& parameter, const std::string& key, double number) const {
    if (controller_ == Controller::klipper || controller_ == Controller::linuxcnc)
      return insert_in_section(key, number);
    // Behind the last setting of a report, in the form of its own lines.
    std::optional<std::size_t> last;
    for (const auto& [k, value] : values_) {
      if (value.at) last = std::max(last.value_or(0), *value.at);
    }
    if (!last) return tl::unexpected(unwritable(name_, parameter.key + " is not in the file, nor any place for it"));
    const std::size_t dollar = text_.rfind('$', *last);
    const bool is_json = dollar != std::string_view::npos && dollar > 0 && text_[dollar - 1] == '"';
    if (is_json) return tl::unexpected(unwritable(name_, parameter.key + " is not in the file, which is JSON"));
    const std::string line = controller_ == Controller::marlin ? key + to_text(number) : key + "=" + to_text(number);
    return with_line(end_of_line(text_, *last), line);
  }

  /// Below the header of its section, else at the end with a header of its own.
  Result<std::string> insert_in_section(const std::string& key, double number) const {
    const std::size_t dot = key.rfind('.');
    const std::string section = key.substr(0, dot), word = key.substr(dot + 1);
    const bool is_ini = controller_ == Controller::linuxcnc;
    const std::string line = word + (is_ini ? " = " : ": ") + to_text(number);
    if (const auto header = end_of_header(section)) return with_line(*header, line);
    return with_line(end_of_own_part(), "[" + section + "]" + newline_ + line);
  }

  std::optional<std::size_t> end_of_header(const std::string& section) const {
    const std::string wanted = upper("[" + section + "]");
    for (std::size_t at = 0; at < text_.size(); at = end_of_line(text_, at)) {
      const std::string_view line = text_.substr(at, end_of_line(text_, at) - at);
      if (line.starts_with('[') && upper(trimmed(line.substr(0, line.find(']') + 1))) == wanted)
        return at + line.size();
    }
    return std::nullopt;
  }

  /// Where the block of Klipper's SAVE_CONFIG begins, which is not for people; else the end.
  std::size_t end_of_own_part() const {
    for (std::size_t at = 0; at < text_.size(); at = end_of_line(text_, at)) {
      if (controller_ == Controller::klipper && text_.substr(at).starts_with("#*#")) return at;
    }
    return text_.size();
  }

  std::string with_line(std::size_t at, const std::string& line) const {
    std::string out(text_.substr(0, at));
    if (!out.empty() && out.back() != '\n') out += newline_;
    return out + line + newline_ + std::string(text_.substr(at));
  }

  std::string_view text_;
  const std::string& name_;
  Controller controller_;
  const ReadIncluded& included_;
  std::string newline_;
  ImportedValues values_;
};

const ControllerParameter* find(const std::vector<ControllerParameter>& list, const std::string& key) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const ControllerParameter& p) { return p.key == key; });
  return at == list.end() ? nullptr : &*at;
}

}  // namespace

Result<std::string> edit_controller_setting(std::string_view text, const std::string& name, Controller controller,
                                            const std::string& key, double value, const ReadIncluded& included) {
  auto settings = parse_controller_settings(text, name, controller, included);
  if (!settings) return tl::unexpected(settings.error());
  const auto list = parameters(*settings);
  const ControllerParameter* parameter = find(list, key);
  if (!parameter) return tl::unexpected(unwritable(name, "there is no setting " + key));
  SettingEditor editor(text, name, controller, included);
  auto edited = editor.set(*parameter, value);
  if (!edited) return edited;
  // Nothing leaves here that does not read back as it was meant.
  auto now = parse_controller_settings(*edited, name, controller, included);
  if (!now) return tl::unexpected(now.error());
  const auto new_list = parameters(*now);
  const ControllerParameter* changed = find(new_list, key);
  const double wanted = value * parameter->size;
  const bool is_right = changed && std::abs(*changed->value - wanted) <= kRounding * std::abs(wanted);
  if (!is_right || !editor.is_all_else_the_same(*edited, *parameter)) {
    return tl::unexpected(unwritable(name, fmt::format("{} cannot be made {} here", key, to_text(value))));
  }
  return edited;
}

}  // namespace toolpace
