#pragma once
/// What flags, machine files and setpoint files call the corner rules.

#include "toolpace/limits/corner_rule.h"

namespace toolpace {

inline constexpr CornerRule kCornerRules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction,
                                              CornerRule::blend, CornerRule::smooth};

constexpr const char* corner_rule_name(CornerRule rule) {
  switch (rule) {
    case CornerRule::stop: return "stop";
    case CornerRule::junction: return "junction";
    case CornerRule::blend: return "blend";
    case CornerRule::smooth: return "smooth";
    default: return "servo";
  }
}

}  // namespace toolpace
