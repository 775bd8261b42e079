#include "toolpace/nc/once_codes.h"

#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/motion/circular_pocket.h"
#include "toolpace/nc/motion/hole_patterns.h"
#include "toolpace/nc/motion/reference_point.h"
#include "toolpace/nc/tool_tip.h"

namespace toolpace::nc {

bool run_once_code(Context& context, const Block& block) {
  const Code code = block.code(GGroup::once);
  if (!refuse_under_tip(context, block)) return false;
  switch (code) {
    case 100: return run_g10(context, block);
    case 280: return go_home(context, block, kHomeG28);
    case 300: return go_home(context, block, kHomeG30);
    case 281: store_home(context, kHomeG28); return true;
    case 301: store_home(context, kHomeG30); return true;
    case kToReference: return go_to_reference(context, block);
    case kFromReference: return leave_reference(context, block);
    case kToolMove: return change_tool_on_the_way(context, block);
    case kPocketRight:
    case kPocketLeft: return mill_circular_pocket(context, block, code);
    case kHolesOnCircle:
    case kHolesOnArc:
    case kHolesOnLine: return run_hole_pattern(context, block, code);
    case kLatheOrigin:
      return !block.has_any(kLinearBits | kRotaryBits | kIncrementBits) || run_g92(context, block, code);
    case 520:
    case 920:
    case 921:
    case 922:
    case 923: return run_g92(context, block, code);
    default: return true;  // G4 comes earlier in the block, G53 belongs to the motion
  }
}

}  // namespace toolpace::nc
