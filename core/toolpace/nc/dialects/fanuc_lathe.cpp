/// Fanuc lathes, G-code system A: X and U are diameters, G98 and G99 are the feed modes.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {

std::optional<CodeUse<GGroup>> fanuc_lathe_g_code(Code code) {
  switch (code) {
    case 870: return CodeUse<GGroup>{GGroup::motion};  // G83 from the side
    case 1840: return CodeUse<GGroup>{GGroup::motion, true, 740};
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
    default: return fanuc_lathe_unfollowed(code) != nullptr ? std::nullopt : fanuc_g_code(code);
  }
}

const char* fanuc_lathe_unfollowed(Code code) {
  switch (code) {
    case 340: return "cuts a thread of changing lead";
    case 350:
    case 360: return "cuts a thread along an arc";
    case 510: return "scales the path";
    case 511: return "mirrors the path";
    case 680: return "mirrors the path for a second turret";
    default: return fanuc_unfollowed(code);
  }
}

constinit const DialectRules kFanucLatheRules = fanuc_lathe_kind(Dialect::fanuc_lathe, fanuc_lathe_g_code);

}  // namespace toolpace::nc
