/// Haas mills: of Fanuc's kind, with codes of their own.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {
namespace {

const char* haas_unfollowed(Code code) {
  switch (code) {
    case 700:
    case 710:
    case 720: return nullptr;
    case 470: return "engraves text";
    case 1500: return "mills a pocket";
    case 1410: return "compensates a tool in space";
    case 1430: return "lengthens the tool in five axes";
    case 2540: return "turns the work offset with the rotary axes";
    case 2680: return "tilts the work plane";
    default: return fanuc_unfollowed(code);
  }
}

std::optional<CodeUse<GGroup>> haas_g_code(Code code) {
  if (haas_unfollowed(code) != nullptr) return std::nullopt;
  if (code >= 1100 && code <= 1290 && code % 10 == 0) return CodeUse<GGroup>{GGroup::system};  // G154 P1 to P20
  switch (code) {
    case 700: return CodeUse<GGroup>{GGroup::once, true, kHolesOnCircle};
    case 710: return CodeUse<GGroup>{GGroup::once, true, kHolesOnArc};
    case 720: return CodeUse<GGroup>{GGroup::once, true, kHolesOnLine};
    case 770: return CodeUse<GGroup>{GGroup::motion, true, kBackBoring};
    case 2340: return CodeUse<GGroup>{GGroup::tool_length, true, 434};
    case 1000: return CodeUse<GGroup>{GGroup::mirror, true, 501};
    case 1010: return CodeUse<GGroup>{GGroup::mirror, true, 511};
    default: return fanuc_g_code(code);
  }
}

std::optional<CodeUse<MGroup>> haas_m_code(int number) {
  if (number == 97) return CodeUse<MGroup>{MGroup::subprogram};
  if (number == 48 || number == 49) return CodeUse<MGroup>{MGroup::ignored};
  return fanuc_m_code(number);
}

}  // namespace

constinit const DialectRules kHaasRules = [] {
  DialectRules rules = fanuc_kind(Dialect::haas);
  rules.repeats_by_k = rules.repeats_within_p = false;  // L repeats
  rules.scales_in_thousandths = rules.machine_moves_rapid = false;
  rules.pecks_shrink = true;
  rules.g_code = haas_g_code;
  rules.m_code = haas_m_code;
  rules.unfollowed = haas_unfollowed;
  return rules;
}();

}  // namespace toolpace::nc
