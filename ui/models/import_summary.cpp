#include "models/import_summary.h"

#include <cmath>

#include "models/parameter_names.h"
#include "models/units.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace::ui {
namespace {

bool is_of_limits(const std::string& section) { return section == "path" || section.starts_with("axes."); }

/// A section as it would be had nobody said anything.
const SetupSection* plain_of(const std::vector<SetupSection>& plain, const SetupSection& section) {
  for (const SetupSection& other : plain) {
    if (other.name == section.name) return &other;
  }
  return nullptr;
}

QString key_value(double value, const NumberKey& key) {
  return number_text(value / key.unit, 9) + (*key.range.unit ? " " + QString::fromUtf8(key.range.unit) : QString());
}

void add_numbers(const SetupSection& section, const SetupSection& plain, bool tells_open,
                 std::vector<ImportRow>& rows) {
  for (std::size_t i = 0; i < section.numbers.size(); ++i) {
    const NumberKey& key = section.numbers[i];
    const bool differs = *key.value != *plain.numbers[i].value;
    if (!differs && !(tells_open && key.range.may_be_infinite)) continue;
    rows.push_back({parameter_name(section.name + "." + key.name), differs ? key_value(*key.value, key) : QString()});
  }
  for (std::size_t i = 0; i < section.ranges.size(); ++i) {
    const RangeKey& key = section.ranges[i];
    const bool differs = *key.low != *plain.ranges[i].low || *key.high != *plain.ranges[i].high;
    if (!differs && !tells_open) continue;
    const auto end = [&key](double value) { return number_text(value / key.unit, 9); };
    const QString unit = QString::fromUtf8(key.range.unit);
    rows.push_back({parameter_name(section.name + "." + key.name),
                    differs ? end(*key.low) + " … " + end(*key.high) + " " + unit : QString()});
  }
}

bool differs_at_all(const SetupSection& section, const SetupSection& plain) {
  std::vector<ImportRow> rows;
  add_numbers(section, plain, false, rows);
  return !rows.empty();
}

}  // namespace

std::vector<ImportRow> import_summary(const Setup& setup) {
  Setup shown = setup, nothing;  // the keys point into them
  const auto plain = setup_sections(nothing);
  std::vector<ImportRow> rows;
  for (const SetupSection& section : setup_sections(shown)) {
    const SetupSection* other = plain_of(plain, section);
    if (!other) continue;
    const bool tells_open = is_of_limits(section.name) && (section.name == "path" || differs_at_all(section, *other));
    add_numbers(section, *other, tells_open, rows);
  }
  return rows;
}

}  // namespace toolpace::ui
