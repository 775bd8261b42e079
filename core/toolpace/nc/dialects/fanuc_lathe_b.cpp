/// Fanuc lathes, G-code system B: G90 and G91, G94 and G95 are what they are on mills, and the cycles are G77 to G79.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

std::optional<CodeUse<GGroup>> lathe_b_g_code(Code code) {
  switch (code) {
    case 770: return CodeUse<GGroup>{GGroup::motion, true, kLatheTurning};
    case 780: return CodeUse<GGroup>{GGroup::motion, true, kLatheThreading};
    case 790: return CodeUse<GGroup>{GGroup::motion, true, kLatheFacing};
    case 330: return CodeUse<GGroup>{GGroup::motion, true, kLatheThread};
    case 920: return CodeUse<GGroup>{GGroup::once, true, kLatheOrigin};
    case 900:
    case 910:
    case 940:
    case 950:
    case 980:
    case 990: return fanuc_g_code(code);
    default: return fanuc_lathe_g_code(code);
  }
}

}  // namespace

const DialectRules kFanucLatheBRules{.dialect = Dialect::fanuc_lathe_b,
                                     .first_retract = 980,
                                     .first_plane = 180,
                                     .first_feed_mode = 950,
                                     .first_lathe_diameter = 70,
                                     .macro_statements = true,
                                     .corner_words = true,
                                     .last_code_wins = true,
                                     .dwells_in_milliseconds = true,
                                     .dwells_by_axis_words = true,
                                     .repeats_by_k = true,
                                     .repeats_within_p = true,
                                     .g80_keeps_motion = true,
                                     .motion_beside_home = true,
                                     .machine_moves_incremental = true,
                                     .ignores_centre_off_plane = true,
                                     .incremental_g10 = true,
                                     .lathe_words = true,
                                     .arc = kLinuxcncArcs,
                                     .g_code = lathe_b_g_code,
                                     .m_code = fanuc_m_code,
                                     .unfollowed = fanuc_lathe_unfollowed};

}  // namespace toolpace::nc
