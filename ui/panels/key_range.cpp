#include "panels/key_range.h"

#include "toolpace/machine/setup_keys.h"

namespace toolpace::ui {

NumberField::Range range_of_key(const std::string& section, const std::string& key) {
  Setup setup;
  setup.options.hold_at = setup.options.corner.step = 0.0;  // all keys of a job
  const NumberKey number = find_number(setup, section, key);
  const double least = number.range.may_be_zero ? 0.0 : number.range.least;
  return {least * number.unit, number.range.most * number.unit, number.range.may_be_infinite};
}

}  // namespace toolpace::ui
