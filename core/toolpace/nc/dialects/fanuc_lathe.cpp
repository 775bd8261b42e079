/// Fanuc lathes, G-code system A: X and U are diameters, G98 and G99 are the feed modes.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {

std::optional<CodeUse<GGroup>> fanuc_lathe_g_code(Code code) {
  switch (code) {
    case 980: return CodeUse<GGroup>{GGroup::feed_mode, true, 940};
    case 990: return CodeUse<GGroup>{GGroup::feed_mode, true, 950};
    case 500: return CodeUse<GGroup>{GGroup::once, true, kLatheOrigin};
    case 320: return CodeUse<GGroup>{GGroup::motion, true, kLatheThread};
    case 900: return CodeUse<GGroup>{GGroup::motion, true, kLatheTurning};
    case 920: return CodeUse<GGroup>{GGroup::motion, true, kLatheThreading};
    case 940: return CodeUse<GGroup>{GGroup::motion, true, kLatheFacing};
    // Checks of spindle and stroke, balanced cutting, mirroring of a second turret off, polygon turning off.
    case 250:
    case 260:
    case 690:
    case 502: return CodeUse<GGroup>{GGroup::ignored};
    case 700:
    case 710:
    case 720:
    case 730:
    case 740:
    case 750:
    case 760: return CodeUse<GGroup>{GGroup::motion, true, static_cast<Code>(kForeignCodes + code)};
    case 680: return std::nullopt;
    default: return fanuc_g_code(code);
  }
}

const char* fanuc_lathe_unfollowed(Code code) {
  switch (code) {
    case 340: return "cuts a thread of changing lead";
    case 680: return "mirrors the path for a second turret";
    default: return fanuc_unfollowed(code);
  }
}

const DialectRules kFanucLatheRules{.dialect = Dialect::fanuc_lathe,
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
                                    .g_code = fanuc_lathe_g_code,
                                    .m_code = fanuc_m_code,
                                    .unfollowed = fanuc_lathe_unfollowed};

}  // namespace toolpace::nc
