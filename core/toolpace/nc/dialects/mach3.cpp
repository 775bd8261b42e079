/// Mach3 and Mach4.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

std::optional<CodeUse<GGroup>> mach3_g_code(Code code) {
  if (code == 700) return CodeUse<GGroup>{GGroup::units, true, 200};
  if (code == 710) return CodeUse<GGroup>{GGroup::units, true, 210};
  if (code == 310) return CodeUse<GGroup>{GGroup::motion, true, 383};
  if (code == 120) return CodeUse<GGroup>{GGroup::once, true, kPocketRight};
  if (code == 130) return CodeUse<GGroup>{GGroup::once, true, kPocketLeft};
  if (code == 401) return CodeUse<GGroup>{GGroup::ignored};  // no arcs at corners
  if (is_listed(code, {500, 510})) return CodeUse<GGroup>{GGroup::scale};
  if (is_listed(code, {680, 690})) return CodeUse<GGroup>{GGroup::turn_plane};
  if (const auto group = common_g_group(code)) return CodeUse<GGroup>{*group};
  return foreign_g_code(code);
}

std::optional<CodeUse<MGroup>> mach3_m_code(int number) {
  if (number == 47) return CodeUse<MGroup>{MGroup::stop};  // begins again without end
  return fanuc_m_code(number);
}

const char* mach3_unfollowed(Code code) {
  switch (code) {
    case 150:
    case 160: return "switches polar coordinates";
    default: return nullptr;
  }
}

}  // namespace

const DialectRules kMach3Rules{.dialect = Dialect::mach3,
                               .first_retract = 980,
                               .last_code_wins = true,
                               .dwells_by_size = true,  // its setting is to be seen nowhere
                               .dwells_by_axis_words = true,
                               .g80_keeps_motion = true,
                               .motion_beside_home = true,
                               .machine_moves_incremental = true,
                               .ignores_centre_off_plane = true,
                               .scales_by_axis_words = true,
                               .pockets_straight = true,
                               .centres_may_be_absolute = true,
                               .arc = kSmallArcs,
                               .g_code = mach3_g_code,
                               .m_code = mach3_m_code,
                               .unfollowed = mach3_unfollowed};

}  // namespace toolpace::nc
