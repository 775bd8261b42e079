#pragma once
/// How a program shall be read.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/kinematics/inverse.h"
#include "toolpace/nc/dialect.h"

namespace toolpace {

/// Bounds that keep any program, however odd, from running without end. Reaching one is an error that names it.
struct ReadLimits {
  std::size_t call_depth = 50;         ///< calls within each other
  std::size_t loop_turns = 2'000'000;  ///< of all loops of a program together
  std::size_t blocks = 8'000'000;      ///< motion blocks, besides one a line of the program
  std::size_t lines = 25'000'000;      ///< lines run again by loops and calls; a line of 16·n bytes counts n + 1 times
};

/// System 1 … 9 is G54 … G59.3, 10 … is G54.1 P1 ….
struct WorkOffset {
  int system = 1;
  std::array<double, kAxisCount> origin{};
};

/// "G54", "g59.3", "G54.1P7": none where it names no system.
std::optional<int> work_system_named(std::string_view name);

/// How coordinates are read that have no decimal point, where controllers differ (Fanuc and its kind).
enum class IntegerWords : std::uint8_t {
  automatic,  ///< as the text suggests, with a warning
  lengths,    ///< X100 is 100 mm
  increments  ///< X100 is 100 least increments: 0.1 mm
};

struct ReadOptions {
  Dialect dialect = Dialect::automatic;
  bool strict = false;  ///< every warning is an error
  IntegerWords integers = IntegerWords::automatic;
  bool block_delete = false;                          ///< skip lines that start with '/'
  std::filesystem::path tools = {};                   ///< LinuxCNC tool table; empty = none
  std::filesystem::path parameters = {};              ///< numbered parameters; empty = none
  std::vector<std::filesystem::path> sub_paths = {};  ///< folders searched for sub-programs, besides the program's own
  std::optional<double> arc_tolerance =
      {};  ///< [mm] how far an arc may end off its radius; none = as the dialect has it
  /// Where work coordinate systems lie that the program does not set: G54 … G59.3, G54.1 P1 … [mm, deg].
  std::vector<WorkOffset> work_offsets = {};
  /// How the machine's rotary axes carry workpiece and tool, and how far they turn: for G43.4, G43.5 and about_tip.
  Kinematics kinematics = {};
  RotaryTravel travel = RotaryTravel::unbounded();
  /// The whole program tells where the tool's tip is in the workpiece, beside the rotary axes.
  bool about_tip = false;
  ReadLimits limits = {};
};

}  // namespace toolpace
