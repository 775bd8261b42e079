#pragma once
/// What controllers see of a program besides its moves: bytes of lines, and codes that make the parser wait.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace toolpace {

/// Kinds of codes in a line, as bits.
enum LineCode : std::uint8_t {
  kSpindleCode = 1,    ///< M3, M4, M5, S
  kCoolantCode = 2,    ///< M7, M8, M9
  kOffsetCode = 4,     ///< G54 … G59
  kOriginCode = 8,     ///< G10, G28, G30, G43.1, G92: never without waiting
  kFinishCode = 16,    ///< M400
  kExtruderWord = 32,  ///< E
  kPathCode = 64       ///< G61, G61.1, G64
};

/// One entry a line, [0] is line 1.
struct ProgramText {
  std::vector<std::uint16_t> bytes;  ///< with the end of the line; longer ones count as 65535
  std::vector<std::uint8_t> codes;   ///< of LineCode
  std::vector<float> extrusion;      ///< [mm] that E feeds in a line, negative back; empty where there is no E at all
  std::uint8_t all_codes = 0;        ///< of all lines

  std::size_t lines() const { return bytes.size(); }
  double extruded_in(std::size_t line) const {
    return line >= 1 && line <= extrusion.size() ? static_cast<double>(extrusion[line - 1]) : 0.0;
  }
};

/// Comments count as bytes and as nothing else. E is read as printers do: M82, M83, G90, G91, G92 and G20 count.
ProgramText scan_program(std::string_view text);

}  // namespace toolpace
