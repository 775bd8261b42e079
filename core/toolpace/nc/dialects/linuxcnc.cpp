/// LinuxCNC 2.9: the dialect that all others are told as differences from.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

std::optional<CodeUse<GGroup>> linuxcnc_g_code(Code code) {
  if (is_listed(code, {700, 710, 711, 712, 720, 721, 722})) return CodeUse<GGroup>{GGroup::motion};
  if (const auto group = common_g_group(code)) return CodeUse<GGroup>{*group};
  if (const auto other = fanuc_g_code(code)) return CodeUse<GGroup>{other->group, false};
  return std::nullopt;
}

std::optional<CodeUse<MGroup>> linuxcnc_m_code(int number) {
  if (const auto group = common_m_group(number)) return CodeUse<MGroup>{*group};
  if (number >= 48 && number <= 53) return CodeUse<MGroup>{MGroup::override_};
  if (number >= 62 && number <= 68) return CodeUse<MGroup>{MGroup::io};
  if (number >= 70 && number <= 73) return CodeUse<MGroup>{MGroup::state};
  if (number >= 100 && number <= 199) return CodeUse<MGroup>{MGroup::user};
  return std::nullopt;
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

}  // namespace toolpace::nc
