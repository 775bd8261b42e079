/// Marlin and other firmware of 3D printers.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {

// Printers do not compare radii; what lies further off than this was meant otherwise.
constexpr ArcTolerance kMarlinArcs{
    .metric = 0.05, .inch = 0.05, .relative = 0.01, .most = 10.0, .least_radius = 0.0001};

namespace {

constexpr Code kFirstMakersCode = 1000;  // makers of printers have codes of their own from G100 on

// Retraction, cleaning, probing and levelling of the bed, tools: nothing that the path of a print depends on.
std::optional<CodeUse<GGroup>> marlin_g_code(Code code) {
  if (is_listed(code, {100, 110, 120, 260, 270, 290, 291, 292, 300, 320, 330, 340, 350, 420, 600, 610, 760, 800, 4250}))
    return CodeUse<GGroup>{GGroup::ignored};
  if (code >= kFirstMakersCode) return CodeUse<GGroup>{GGroup::machine};
  return sender_g_code(code);
}

std::optional<CodeUse<MGroup>> marlin_m_code(int number) {
  if (is_listed(number, {201, 203, 204, 205})) return CodeUse<MGroup>{MGroup::limits};
  // Macros of files, by name: M98 P"/macros/prime.g".
  if (number == 98 || number == 99) return CodeUse<MGroup>{MGroup::ignored};
  return sender_m_code(number);
}

}  // namespace

const DialectRules kMarlinRules{.dialect = Dialect::marlin,
                                .first_feed = 1500.0,
                                .sender_lines = true,
                                .line_checksums = true,
                                .extruder = true,
                                .texts_without_quotes = true,
                                .ends_with_text = true,
                                .dwells_in_milliseconds = true,
                                .dwells_by_axis_words = true,
                                .rapids_at_feed = true,
                                .machine_moves_incremental = true,
                                .ignores_centre_off_plane = true,
                                .arc = kMarlinArcs,
                                .g_code = marlin_g_code,
                                .m_code = marlin_m_code,
                                .unfollowed = nothing_unfollowed};

}  // namespace toolpace::nc
