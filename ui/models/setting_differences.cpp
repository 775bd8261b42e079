#include "models/setting_differences.h"

#include <QCoreApplication>
#include <array>
#include <cmath>
#include <string_view>

#include "models/law_names.h"
#include "models/option_names.h"
#include "models/parameter_names.h"
#include "toolpace/base/axes.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace::ui {
namespace {

struct UnitName {
  std::string_view text;
  Quantity quantity;
};
constexpr std::array kUnitNames = {UnitName{"mm", Quantity::length},
                                   UnitName{"mm/s", Quantity::speed},
                                   UnitName{"mm/s²", Quantity::acceleration},
                                   UnitName{"mm/s³", Quantity::jerk},
                                   UnitName{"deg", Quantity::angle},
                                   UnitName{"deg/s", Quantity::angular_speed},
                                   UnitName{"deg/s²", Quantity::angular_acceleration},
                                   UnitName{"deg/s³", Quantity::angular_jerk}};

/// In the unit that the window shows, where the key is of a length or an angle; else in the key's own.
QString value_of(double core_value, const NumberKey& key, Units units) {
  for (const UnitName& name : kUnitNames) {
    if (name.text == key.range.unit) return value_text(core_value, name.quantity, units, 7);
  }
  const QString unit = QString::fromUtf8(key.range.unit);
  return number_text(core_value / key.unit, 7) + (unit.isEmpty() ? QString() : " " + unit);
}

QString name_of(const SetupSection& section, const std::string& key) {
  return parameter_name(section.name.empty() ? key : section.name + "." + key);
}

void add_numbers(const SetupSection& a, const SetupSection& b, Units units, std::vector<SettingDifference>& list) {
  for (std::size_t i = 0; i < a.numbers.size() && i < b.numbers.size(); ++i) {
    if (*a.numbers[i].value == *b.numbers[i].value) continue;
    list.push_back({name_of(a, a.numbers[i].name), value_of(*a.numbers[i].value, a.numbers[i], units),
                    value_of(*b.numbers[i].value, b.numbers[i], units)});
  }
  for (std::size_t i = 0; i < a.ranges.size() && i < b.ranges.size(); ++i) {
    const RangeKey &of_a = a.ranges[i], &of_b = b.ranges[i];
    if (*of_a.low == *of_b.low && *of_a.high == *of_b.high) continue;
    const auto text = [](const RangeKey& key) {
      return number_text(*key.low / key.unit, 7) + " … " + number_text(*key.high / key.unit, 7) + " " +
             QString::fromUtf8(key.range.unit);
    };
    list.push_back({name_of(a, of_a.name), text(of_a), text(of_b)});
  }
}

QString tr(const char* text) { return QCoreApplication::translate("SettingDifferences", text); }

void add_words(const Job& a, const Job& b, Units units, std::vector<SettingDifference>& list) {
  const auto add = [&list](const char* title, const QString& of_a, const QString& of_b) {
    if (of_a != of_b) list.push_back({tr(title), of_a, of_b});
  };
  const auto text = [](const std::string& name) { return name.empty() ? QString("–") : QString::fromStdString(name); };
  const auto depth = [](const PlanOptions& o) {
    return o.lookahead ? number_text(static_cast<double>(*o.lookahead), 9) : QString("∞");
  };
  const auto optional = [units](const std::optional<double>& value, Quantity quantity) {
    return value ? value_text(*value, quantity, units, 7) : QString("–");
  };
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Program"), text(a.program_name), text(b.program_name));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Machine"), text(a.machine.name), text(b.machine.name));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Law"), law_title(law_row(a.options.law)),
      law_title(law_row(b.options.law)));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Look-ahead"), depth(a.options), depth(b.options));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Ramps"), ramps_title(a.options.ramps), ramps_title(b.options.ramps));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Corners"), corner_title(a.options.corner.rule),
      corner_title(b.options.corner.rule));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Shaper"), shaper_title(a.options.shaper),
      shaper_title(b.options.shaper));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const QString of_a = modes_text(a.machine.servo[axis].modes), of_b = modes_text(b.machine.servo[axis].modes);
    if (a.machine.servo[axis].modes == b.machine.servo[axis].modes) continue;
    list.push_back(
        {tr(QT_TRANSLATE_NOOP("SettingDifferences", "Modes of %1")).arg(QLatin1Char(kAxisNames[axis])), of_a, of_b});
  }
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Speed step at corners"),
      optional(a.options.corner.step, Quantity::speed), optional(b.options.corner.step, Quantity::speed));
  add(QT_TRANSLATE_NOOP("SettingDifferences", "Feed hold"), optional(a.options.hold_at, Quantity::time),
      optional(b.options.hold_at, Quantity::time));
}

}  // namespace

std::vector<SettingDifference> setting_differences(const Job& a, const Job& b, Units units) {
  std::vector<SettingDifference> list;
  add_words(a, b, units, list);
  Setup of_a{a.machine, a.options}, of_b{b.machine, b.options};  // the keys point into them
  // What is there only sometimes is told above.
  for (Setup* setup : {&of_a, &of_b}) {
    setup->options.hold_at.reset();
    setup->options.corner.step.reset();
  }
  auto sections_a = setup_sections(of_a), sections_b = setup_sections(of_b);
  sections_a.push_back(job_section(of_a.options));
  sections_b.push_back(job_section(of_b.options));
  for (std::size_t i = 0; i < sections_a.size(); ++i) add_numbers(sections_a[i], sections_b[i], units, list);
  return list;
}

bool has_same_settings(const Job& a, const Job& b) {
  return a.program == b.program && setting_differences(a, b, {}).empty();
}

}  // namespace toolpace::ui
