#pragma once
/// The dialects of RS-274 that programs are written in.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace toolpace {

enum class Dialect : std::uint8_t { automatic, linuxcnc, fanuc, fanuc_lathe, fanuc_lathe_b, haas, mach3, grbl, marlin };

/// "fanuc-lathe": as flags and tables name it; "auto" where the text shall decide.
std::string_view dialect_name(Dialect dialect);
std::optional<Dialect> dialect_named(std::string_view name);

/// All of them, automatic first.
std::span<const Dialect> all_dialects();

}  // namespace toolpace
