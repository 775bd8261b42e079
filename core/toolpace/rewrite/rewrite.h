#pragma once
/// Program text -> program text that does the same in fewer, longer blocks, proven.

#include <cstddef>
#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/read_options.h"
#include "toolpace/nc/reading.h"

namespace toolpace {

struct RewriteOptions {
  double tolerance = 0.01;  ///< [mm] > 0: how far the new path may be from the old one
  bool has_arcs = true;     ///< arcs and helices, too; else lines alone
};

struct Rewritten {
  std::string text;
  Reading reading;             ///< of the text
  std::size_t runs = 0;        ///< stretches of plain feed moves that were looked at
  std::size_t replaced = 0;    ///< of these, those that stand in fewer blocks now
  std::size_t unproven = 0;    ///< left as they were because what was written in their place did not pass the proof
  double max_deviation = 0.0;  ///< [mm] between both paths, measured by verify's walk; rounded up
};

/// Replaces runs of plain G1, G2 and G3 lines by the longest lines, arcs and helices within the tolerance. Everything else stays
/// byte for byte, and so do runs that gain nothing.
///
/// The distance is that of a walk along both paths which never goes back (Fréchet). Blocks end where rows of the program do, in
/// the program's own numbers, so that positions at all that is no feed move are the same to the bit. Corners stay (curve.h). The
/// result was read again, and everything above proven on that; what does not pass is left as it was.
///
/// @param reading  of `text`, as read_text(text, name, read_options) has it
/// @return errors: input ("program-refused"); cancelled
Result<Rewritten> rewrite(std::string_view text, const std::string& name, const Reading& reading,
                          const ReadOptions& read_options, const RewriteOptions& options = {},
                          const Monitor& monitor = {});

}  // namespace toolpace
