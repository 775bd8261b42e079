/// Fanuc mills, and what all of Fanuc's kind share.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {

std::optional<CodeUse<GGroup>> fanuc_g_code(Code code) {
  if (is_listed(code, {650, 660, 670})) return CodeUse<GGroup>{GGroup::macro};
  if (is_listed(code, {680, 690})) return CodeUse<GGroup>{GGroup::turn_plane};
  if (is_listed(code, {150, 160})) return CodeUse<GGroup>{GGroup::polar};
  if (code == 310) return CodeUse<GGroup>{GGroup::motion, true, 383};  // a skip: to its end, if no signal comes
  if (code == 440) return CodeUse<GGroup>{GGroup::tool_length};
  if (code == 760) return CodeUse<GGroup>{GGroup::motion, true, 860};  // fine boring: the shift aside is left out
  if (code == 541) return CodeUse<GGroup>{GGroup::system};
  // Smoothing, exact stops and cutting modes, single-direction positioning, stroke limits, scaling and mirroring off.
  if (is_listed(code, {50, 51, 80, 90, 220, 230, 270, 401, 500, 501, 600, 620, 630, 641}))
    return CodeUse<GGroup>{GGroup::ignored};
  if (const auto group = common_g_group(code)) return CodeUse<GGroup>{*group};
  return std::nullopt;
}

const char* fanuc_unfollowed(Code code) {
  switch (code) {
    case 700:
    case 710:
    case 720:
    case 750: return "turns a contour given by its line numbers";
    case 71: return "wraps the path around a cylinder";
    case 121:
    case 1120: return "interpolates in polar coordinates";
    case 511: return "mirrors the path";
    case 510: return "scales the path";
    default: return nullptr;
  }
}

std::optional<CodeUse<MGroup>> fanuc_m_code(int number) {
  if (const auto group = common_m_group(number)) return CodeUse<MGroup>{*group};
  if (number == 198) return CodeUse<MGroup>{MGroup::subprogram};
  if (number >= 0 && number < 10000) return CodeUse<MGroup>{MGroup::ignored};
  return std::nullopt;
}

constinit const DialectRules kFanucRules = fanuc_kind(Dialect::fanuc);

}  // namespace toolpace::nc
