#include "toolpace/nc/dwell.h"

#include <fmt/format.h>

namespace toolpace::nc {

double dwell_of(Context& context, const Block& block) {
  constexpr double kMillisecondsFrom = 100.0;
  const double p = block.of('p');
  const bool is_count = !block.has_point('p');
  if (context.rules.dwells_in_milliseconds && (is_count || !context.rules.macro_statements)) return p / 1000.0;
  if (!context.rules.dwells_by_size || !is_count || !(p >= kMillisecondsFrom)) return p;
  context.faults.warn(
      "dwell-uncertain", fmt::format("a dwell of P{0:g} is read as {0:g} ms; it may be meant as {0:g} s", p),
      "name the dialect with --dialect: linuxcnc and grbl dwell in s, fanuc and marlin in ms", block.column_of('p'));
  return p / 1000.0;
}

}  // namespace toolpace::nc
