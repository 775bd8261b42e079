#pragma once
/// The dialects of RS-274 that programs are written in.

#include <cstdint>

namespace toolpace {

enum class Dialect : std::uint8_t { automatic, linuxcnc, fanuc, grbl };

}  // namespace toolpace
