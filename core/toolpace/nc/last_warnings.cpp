#include "toolpace/nc/last_warnings.h"

#include <fmt/format.h>

#include <string>

#include "toolpace/nc/text/line_kinds.h"

namespace toolpace::nc {
namespace {

void warn_of_mended_arcs(const ReadingEnd& end) {
  const MendedArcs& mended = end.state.mended;
  if (mended.count == 0) return;
  const std::string others = mended.count == 1 ? "" : fmt::format(", the worst of {} arcs", mended.count);
  end.log.add({"arc-mended",
               fmt::format("the arc ends {:.4f} mm off its radius{}; it is taken as a spiral", mended.worst, others),
               "give more decimals; --arc-tolerance-mm decides what is refused", 0, Severity::warning},
              end.files.at(mended.file).name, mended.line, {});
}

// Whether inches or millimetres hold is a setting of these machines.
void warn_of_missing_units(const ReadingEnd& end) {
  if (!end.rules.macro_statements || end.state.units_given || end.moves.size() == 0) return;
  end.log.add({"units-missing", "neither G20 nor G21 is given: lengths are read in mm",
               "write G20 for inches, or G21 for mm, at the beginning", 0, Severity::warning},
              end.files.at(0).name, end.moves.line.front(), {});
}

// M128 is free for the builders of Fanuc's machines; on Heidenhain's it leads the tool's tip.
void warn_of_tip(const ReadingEnd& end) {
  const auto& code = end.state.tip_code;
  if (!code) return;
  for (std::size_t row = code->row; row < end.moves.size(); ++row) {
    const AxisVector before = row == 0 ? AxisVector(AxisVector::Zero()) : AxisVector(end.moves.end[row - 1]);
    if (!is_motion(end.moves.kind[row]) || end.moves.end[row].tail<3>() == before.tail<3>()) continue;
    end.log.add(
        {"tip-doubtful",
         fmt::format("rotary axes move behind M128 of line {}, which may lead the tool's tip (Heidenhain); it is "
                     "taken to do nothing",
                     code->line),
         "use G43.4 H or G43.5 H, or read the whole program so with --tcp", 0, Severity::warning},
        end.files.at(end.moves.file[row]).name, end.moves.line[row], {});
    return;
  }
}

}  // namespace

void warn_at_the_end(const ReadingEnd& end) {
  warn_of_mended_arcs(end);
  warn_of_missing_units(end);
  warn_of_tip(end);
}

// It was meant to be run, or the end is of something else.
void warn_of_text_behind_end(const ReadingEnd& end, std::size_t line, std::string_view rest) {
  if (end.rules.refuses_doubtful) return;
  const auto first = find_stray_motion(rest);
  if (!first) return;
  end.log.add({"text-behind-end",
               fmt::format("the program ends in line {}; line {} behind it is not run", line, line + 1 + *first),
               "remove what stands behind the end, or the end", 0, Severity::warning},
              end.files.at(0).name, line + 1 + *first, {});
}

}  // namespace toolpace::nc
