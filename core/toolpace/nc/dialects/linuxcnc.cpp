/// LinuxCNC 2.9: the dialect that all others are told as differences from.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

std::optional<CodeUse<GGroup>> linuxcnc_g_code(Code code) {
  if (is_listed(code, {700, 710, 711, 712, 720, 721, 722})) return CodeUse<GGroup>{GGroup::motion};
  if (const auto group = common_g_group(code)) return CodeUse<GGroup>{*group};
  return foreign_g_code(code);
}

std::optional<CodeUse<MGroup>> linuxcnc_m_code(int number) {
  if (const auto group = common_m_group(number)) return CodeUse<MGroup>{*group};
  if (number >= 48 && number <= 53) return CodeUse<MGroup>{MGroup::override_};
  if (number >= 62 && number <= 68) return CodeUse<MGroup>{MGroup::io};
  if (number >= 70 && number <= 73) return CodeUse<MGroup>{MGroup::state};
  if (number >= 100 && number <= 199) return CodeUse<MGroup>{MGroup::user};
  return std::nullopt;
}

std::optional<CodeUse<GGroup>> unmarked_g_code(Code code) {
  if (const auto use = linuxcnc_g_code(code); use && use->by_dialect) return use;
  auto other = fanuc_g_code(code);
  if (!other) other = tinyg_g_code(code);
  const bool moves = other && other->group != GGroup::ignored && other->group != GGroup::machine;
  if (moves) other->by_dialect = false;
  return other;
}

std::optional<CodeUse<MGroup>> unmarked_m_code(int number) {
  if (const auto use = linuxcnc_m_code(number)) return use;
  return fanuc_m_code(number);
}

}  // namespace

const DialectRules kLinuxcncRules{.dialect = Dialect::linuxcnc,
                                  .first_motion = 800,
                                  .refuses_doubtful = true,
                                  .acts_by_comment = true,
                                  .linuxcnc_cycles = true,
                                  .arc = kLinuxcncArcs,
                                  .g_code = linuxcnc_g_code,
                                  .m_code = linuxcnc_m_code,
                                  .unfollowed = nothing_unfollowed};

const DialectRules kUnmarkedRules{.dialect = Dialect::linuxcnc,
                                  .first_motion = 800,
                                  .line_checksums = true,
                                  .acts_by_comment = true,
                                  .last_code_wins = true,
                                  .dwells_by_size = true,
                                  .dwells_by_axis_words = true,
                                  .motion_beside_home = true,
                                  .machine_moves_incremental = true,
                                  .ignores_centre_off_plane = true,
                                  .linuxcnc_cycles = true,
                                  .centres_may_be_absolute = true,
                                  .arc = kSmallArcs,
                                  .g_code = unmarked_g_code,
                                  .m_code = unmarked_m_code,
                                  .unfollowed = nothing_unfollowed};

}  // namespace toolpace::nc
