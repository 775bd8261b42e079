/// Programs of any dialect, written again: what plans is not refused, and what is written reads in the same dialect, ends where the
/// program does, keeps all rows that are no feed moves, and is within the tolerance by its own proof. The first byte chooses the
/// dialect, the second one the tolerance and what may be written.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "toolpace/nc/reader.h"
#include "toolpace/rewrite/rewrite.h"

namespace {

using namespace toolpace;

constexpr std::size_t kMostRows = 2000;

void check(bool holds) {
  if (!holds) std::abort();
}

bool is_feed(const Moves& moves, std::size_t row) {
  return moves.kind[row] == MoveKind::feed || moves.kind[row] == MoveKind::arc;
}

std::size_t behind_feeds(const Moves& moves, std::size_t row) {
  while (row < moves.size() && is_feed(moves, row)) ++row;
  return row;
}

/// All rows but feed moves, in order, where they were.
void check_events(const Moves& a, const Moves& b) {
  std::size_t i = behind_feeds(a, 0), j = behind_feeds(b, 0);
  for (; i < a.size() && j < b.size(); i = behind_feeds(a, i + 1), j = behind_feeds(b, j + 1)) {
    check(a.kind[i] == b.kind[j] && a.end[i] == b.end[j] && a.begin_of(i) == b.begin_of(j));
  }
  check(i == a.size() && j == b.size());
  if (a.size() > 0) check(b.size() > 0 && a.end.back() == b.end.back());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  constexpr Dialect kDialects[] = {Dialect::linuxcnc, Dialect::grbl,  Dialect::fanuc, Dialect::fanuc_lathe,
                                   Dialect::haas,     Dialect::mach3, Dialect::marlin};
  constexpr double kTolerances[] = {1e-6, 0.001, 0.01, 0.1, 10};
  ReadOptions read;
  read.dialect = kDialects[data[0] % std::size(kDialects)];
  RewriteOptions options;
  options.tolerance = kTolerances[data[1] % std::size(kTolerances)];
  options.has_arcs = (data[1] & 0x80) == 0;
  if ((data[1] & 0x40) != 0) {
    options.feeds.emplace();
    options.feeds->block_time = 0.02;
    for (AxisLimits& axis : options.feeds->machine.axes) axis.speed = 20, axis.acceleration = 100;
  }
  const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
  const auto before = read_text(text, "fuzz.nc", read);
  if (!before || before->refused || before->moves.size() > kMostRows || before->moves.has_tip()) return 0;
  const auto written = rewrite(text, "fuzz.nc", *before, read, options);
  check(written.has_value());
  check(written->max_deviation <= options.tolerance);
  const auto after = read_text(written->text, "fuzz.nc", read);
  check(after && !after->refused);
  check_events(before->moves, after->moves);
  return 0;
}
