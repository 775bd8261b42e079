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

constinit const DialectRules kFanucLatheBRules = fanuc_lathe_kind(Dialect::fanuc_lathe_b, lathe_b_g_code);

}  // namespace toolpace::nc
