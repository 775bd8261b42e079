/// grbl and its descendants, which senders stream programs to.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {

std::optional<CodeUse<GGroup>> tinyg_g_code(Code code) {
  if (code == 283) return CodeUse<GGroup>{GGroup::once, false, 920};           // here is X Y Z
  if (code == 282 || code == 284) return CodeUse<GGroup>{GGroup::kept, true};  // homing
  return std::nullopt;
}

std::optional<CodeUse<GGroup>> sender_g_code(Code code) {
  const bool has =
      is_listed(code, {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281, 300, 301, 382, 383, 384, 385,
                       400, 431, 490, 530, 540, 550, 560, 570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940});
  if (const auto group = common_g_group(code)) return CodeUse<GGroup>{*group, has};
  if (code == 290) return CodeUse<GGroup>{GGroup::ignored};  // printers probe their bed
  if (const auto use = tinyg_g_code(code)) return use;
  return foreign_g_code(code);
}

std::optional<CodeUse<MGroup>> sender_m_code(int number) {
  if (const auto group = common_m_group(number)) return CodeUse<MGroup>{*group, *group != MGroup::subprogram};
  if (number >= 0 && number < 10000) return CodeUse<MGroup>{MGroup::ignored};
  return std::nullopt;
}

namespace {

// grblHAL holds overrides as LinuxCNC does.
std::optional<CodeUse<MGroup>> grbl_m_code(int number) {
  if (number >= 48 && number <= 51) return CodeUse<MGroup>{MGroup::override_};
  return sender_m_code(number);
}

}  // namespace

// grbl 1.1: 0.005 mm always, else 0.1 % of the radius and at most 0.5 mm.
constexpr ArcTolerance kGrblArcs{
    .metric = 0.005, .inch = 0.005, .relative = 0.001, .most = 100.0, .least_radius = 0.0001};

const DialectRules kGrblRules{.dialect = Dialect::grbl,
                              .sender_lines = true,
                              .line_checksums = true,
                              .extruder = true,
                              .texts_without_quotes = true,
                              .ends_with_text = true,
                              .dwells_by_axis_words = true,
                              .machine_moves_incremental = true,
                              .ignores_centre_off_plane = true,
                              .arc = kGrblArcs,
                              .g_code = sender_g_code,
                              .m_code = grbl_m_code,
                              .unfollowed = nothing_unfollowed};

}  // namespace toolpace::nc
