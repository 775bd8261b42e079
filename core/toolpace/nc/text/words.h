#pragma once
/// What one line of a program says: its words, sorted by letter and modal group.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace toolpace::nc {

/// G codes are held in tenths: G38.2 is 382.
using Code = std::int16_t;
inline constexpr Code kNoCode = -1;

/// Codes that mean something else under the same number in other dialects: they are shown as they are written.
inline constexpr Code kForeignCodes = 20000;
inline constexpr Code kLatheOrigin = kForeignCodes + 500;     ///< G50
inline constexpr Code kLatheThread = kForeignCodes + 320;     ///< G32
inline constexpr Code kLatheTurning = kForeignCodes + 900;    ///< G90
inline constexpr Code kLatheThreading = kForeignCodes + 920;  ///< G92
inline constexpr Code kLatheFacing = kForeignCodes + 940;     ///< G94

inline constexpr Code kLatheFinish = kForeignCodes + 700;      ///< G70
inline constexpr Code kLatheRough = kForeignCodes + 710;       ///< G71
inline constexpr Code kLatheFaceRough = kForeignCodes + 720;   ///< G72
inline constexpr Code kLatheRepeat = kForeignCodes + 730;      ///< G73
inline constexpr Code kLatheFaceGroove = kForeignCodes + 740;  ///< G74
inline constexpr Code kLatheGroove = kForeignCodes + 750;      ///< G75
inline constexpr Code kLatheThreads = kForeignCodes + 760;     ///< G76

inline constexpr Code kMillCodes = 25000;                 ///< the same of mills of Fanuc's kind
inline constexpr Code kPocketRight = kMillCodes + 120;    ///< G12
inline constexpr Code kPocketLeft = kMillCodes + 130;     ///< G13
inline constexpr Code kFineBoring = kMillCodes + 760;     ///< G76
inline constexpr Code kBackBoring = kMillCodes + 870;     ///< G87
inline constexpr Code kHolesOnCircle = kMillCodes + 700;  ///< G70 of Haas
inline constexpr Code kHolesOnArc = kMillCodes + 710;     ///< G71 of Haas
inline constexpr Code kHolesOnLine = kMillCodes + 720;    ///< G72 of Haas
inline constexpr Code kContourControl = kMillCodes + 51;  ///< G5.1 of Fanuc
inline constexpr Code kSmoothness = 1870;                 ///< G187 of Haas
inline constexpr Code kToReference = kMillCodes + 270;    ///< G27
inline constexpr Code kToolMove = kMillCodes + 1000;      ///< G100 of Brother
inline constexpr Code kFromReference = kMillCodes + 290;  ///< G29

/// Modal groups of G codes (RS-274/NGC numbering where it has one).
enum class GGroup : std::uint8_t {
  once,            ///< G4 G10 G28 G30 G52 G53 G92 …
  motion,          ///< G0 G1 G2 G3 G5 G33 G38 G73 G76 G80 …
  plane,           ///< G17 G18 G19
  distance,        ///< G90 G91
  arc_distance,    ///< G90.1 G91.1
  feed_mode,       ///< G93 G94 G95
  units,           ///< G20 G21
  compensation,    ///< G40 G41 G42
  tool_length,     ///< G43 G49
  retract,         ///< G98 G99
  system,          ///< G54 … G59.3
  path_control,    ///< G61 G64
  spindle_mode,    ///< G96 G97
  lathe_diameter,  ///< G7 G8
  macro,           ///< G65 G66 G67 (Fanuc)
  turn_plane,      ///< G68 G69 (Fanuc)
  polar,           ///< G15 G16 (Fanuc)
  scale,           ///< G50 G51 (Fanuc)
  mirror,          ///< G50.1 G51.1 (Fanuc)
  ignored,         ///< known, without effect on the path
  kept,            ///< the same, and the block's words belong to it
  machine,         ///< the same, defined by the machine
  count
};

enum class MGroup : std::uint8_t {
  stop,
  io,
  tool,
  spindle,
  coolant,
  override_,
  limits,  ///< M201 M203 M204 M205 of printers
  state,
  user,
  subprogram,
  ignored,
  count
};

/// Letters as indices: 'a' = 0. '@' and '^' (polar radius and angle) follow, and words of other characters.
inline constexpr std::size_t kRadiusWord = 26;
inline constexpr std::size_t kAngleWord = 27;
inline constexpr std::size_t kChamferWord = 28;    ///< ",C"
inline constexpr std::size_t kFilletWord = 29;     ///< ",R"
inline constexpr std::size_t kSpindleWord = 30;    ///< "$"
inline constexpr std::size_t kLineAngleWord = 31;  ///< ",A"
inline constexpr std::size_t kWordCount = 32;

constexpr std::size_t word_index(char letter) { return static_cast<std::size_t>(letter - 'a'); }
constexpr std::uint32_t word_bit(char letter) { return 1u << word_index(letter); }
inline constexpr std::uint32_t kPolarBits = (1u << kRadiusWord) | (1u << kAngleWord);
inline constexpr std::uint32_t kCornerBits = (1u << kChamferWord) | (1u << kFilletWord);
inline constexpr std::uint32_t kLineAngleBit = 1u << kLineAngleWord;
inline constexpr std::uint32_t kIncrementBits = word_bit('u') | word_bit('v') | word_bit('w');
inline constexpr std::uint32_t kLinearBits = word_bit('x') | word_bit('y') | word_bit('z');
inline constexpr std::uint32_t kRotaryBits = word_bit('a') | word_bit('b') | word_bit('c');
inline constexpr std::uint32_t kAxisBits = kLinearBits | kRotaryBits | kPolarBits;
inline constexpr std::uint32_t kCentreBits = word_bit('i') | word_bit('j') | word_bit('k');

inline constexpr std::array<char, 6> kAxisLetters = {'x', 'y', 'z', 'a', 'b', 'c'};

struct MacroArgument {
  char letter;
  double value;
};

struct Block {
  std::uint32_t words = 0;    ///< bit set of the words present, G M N O not among them
  std::uint32_t pointed = 0;  ///< those of them that are written with a decimal point
  std::uint32_t counted =
      0;  ///< coordinates written as whole numbers without a point, where those may count increments
  std::uint32_t g_groups = 0;  ///< bit set of GGroup
  std::uint32_t m_groups = 0;  ///< bit set of MGroup
  std::array<double, kWordCount> value;
  std::array<std::uint32_t, kWordCount> column;  ///< of the word's letter, from 1
  std::array<Code, static_cast<std::size_t>(GGroup::count)> g;
  std::array<Code, static_cast<std::size_t>(MGroup::count)> m;
  std::array<std::uint32_t, static_cast<std::size_t>(GGroup::count)> g_column;
  std::array<std::uint32_t, static_cast<std::size_t>(MGroup::count)> m_column;
  std::vector<MacroArgument> arguments;  ///< of G65, in the order written
  std::string message;                   ///< text of the last comment where someone may need it (alarms)
  std::string called;                    ///< of M98 <NAME>, in small letters

  void clear() {
    words = pointed = counted = g_groups = m_groups = 0;
    if (!arguments.empty()) arguments.clear();
    if (!message.empty()) message.clear();
    if (!called.empty()) called.clear();
  }
  bool is_empty() const { return words == 0 && g_groups == 0 && m_groups == 0; }
  bool has(char letter) const { return (words & word_bit(letter)) != 0; }
  bool has_any(std::uint32_t bits) const { return (words & bits) != 0; }
  bool has_point(char letter) const { return (pointed & word_bit(letter)) != 0; }
  double of(char letter) const { return value[word_index(letter)]; }
  double of(char letter, double otherwise) const { return has(letter) ? of(letter) : otherwise; }
  std::size_t column_of(char letter) const { return has(letter) ? column[word_index(letter)] : 0; }

  bool has(GGroup group) const { return (g_groups & (1u << static_cast<unsigned>(group))) != 0; }
  bool has(MGroup group) const { return (m_groups & (1u << static_cast<unsigned>(group))) != 0; }
  Code code(GGroup group) const { return has(group) ? g[static_cast<std::size_t>(group)] : kNoCode; }
  Code code(MGroup group) const { return has(group) ? m[static_cast<std::size_t>(group)] : kNoCode; }
  std::size_t column_of(GGroup group) const { return has(group) ? g_column[static_cast<std::size_t>(group)] : 0; }
  std::size_t column_of(MGroup group) const { return has(group) ? m_column[static_cast<std::size_t>(group)] : 0; }
};

/// "G38.2" of 382.
std::string code_text(char letter, Code code);

}  // namespace toolpace::nc
