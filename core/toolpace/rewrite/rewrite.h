#pragma once
/// Program text -> program text that does the same in fewer, longer blocks, proven.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/read_options.h"
#include "toolpace/nc/reading.h"
#include "toolpace/rewrite/feeds.h"

namespace toolpace {

/// How long a program takes [s].
struct ProgramTime {
  double total = 0.0;
  std::vector<double> row;  ///< of each row of its moves
};

/// Tells how long a program takes on the machine that it is for: its reading, and its text.
using ProgramTimer = std::function<Result<ProgramTime>(const Reading& reading, std::string_view text)>;

struct RewriteOptions {
  double tolerance = 0.01;               ///< [mm] > 0: how far the new path may be from the old one
  bool has_arcs = true;                  ///< arcs and helices, too; else lines alone
  ProgramTimer timer = {};               ///< where it is given, parts that would take longer are left as they were
  std::optional<FeedLimits> feeds = {};  ///< where they are given, feeds are lowered to what keeps them; after all else
};

/// A stretch of the program that was written anew. Rows are those of Moves.
struct RewrittenPart {
  std::size_t first = 0, last = 0;          ///< of the program: first … last − 1
  std::size_t new_first = 0, new_last = 0;  ///< what stands for them
};

struct Rewritten {
  std::string text;
  Reading reading;             ///< of the text
  double max_deviation = 0.0;  ///< [mm] between both paths, measured by verify's walk; rounded up
  std::size_t replaced = 0;    ///< blocks that stand for several of the program
  std::size_t unproven = 0;    ///< others that were tried, did not pass the proof, and were taken back
  std::size_t slower = 0;      ///< rows of the program that stay as they were because the machine would take longer
  std::optional<double> time_before, time_after;  ///< [s] by the timer
  std::vector<RewrittenPart> parts = {};          ///< in the order of the program
};

/// Replaces runs of plain G1, G2 and G3 lines by the longest lines, arcs and helices within the tolerance. Everything else stays
/// byte for byte, and so does what gains nothing.
///
/// The distance is that of a walk along both paths which never goes back (Fréchet). Blocks end where rows of the program do, in
/// the program's own numbers, so that positions at all that is no feed move are the same to the bit. Corners stay (curve.h). The
/// result was read again, and everything above proven on that; what does not pass is left as it was. With a timer the result
/// never takes longer than the program, but for what planned feeds cost.
///
/// @param reading  of `text`, as read_text(text, name, read_options) has it
/// @return errors: input ("program-refused"); cancelled; of the timer
Result<Rewritten> rewrite(std::string_view text, const std::string& name, const Reading& reading,
                          const ReadOptions& read_options, const RewriteOptions& options = {},
                          const Monitor& monitor = {});

}  // namespace toolpace
