#pragma once
/// What was modal where: active codes, work offset, tool, F and S at every line of a program.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace toolpace {

/// Modal state after a line. Codes are in tenths (G59.1 is 591).
struct ModalSnapshot {
  std::int16_t motion = 800, plane = 170, units = 210, distance = 900, arc_distance = 911, feed_mode = 940,
               compensation = 400, tool_length = 490, retract = 990, path_control = 640, spindle_mode = 970,
               lathe_diameter = 80;
  std::int16_t system = 1;            ///< 1 … 9: G54 … G59.3
  std::int32_t tool = 0;              ///< in the spindle
  std::int8_t spindle_direction = 0;  ///< −1 M4, 0 M5, +1 M3
  bool mist = false, flood = false;
  double spindle_speed = 0.0;  ///< [rev/min]
  double tolerance = 0.0;      ///< [mm] of G64 P; 0 = none
  double feed = 0.0;           ///< F as programmed, in the program's units and feed mode
  bool operator==(const ModalSnapshot&) const = default;

  /// "G1 G17 G21 G90 G91.1 G94 G54 G40 G49 G64 G97 G99"
  std::string codes() const;
  /// "G54" … "G59.3"
  std::string work_offset() const;
};

/// Changes of the modal state in the order of execution; lines without a change are not listed.
class ModalLog {
 public:
  void record(std::size_t file, std::size_t line, const ModalSnapshot& snapshot);

  /// State after the last recorded change at or before `line` of file `file`; none before the first.
  std::optional<ModalSnapshot> at(std::size_t line, std::size_t file = 0) const;
  std::size_t size() const { return changes_.size(); }

 private:
  struct Change {
    std::uint32_t line;
    std::uint16_t file;
    std::uint16_t state;
    double feed;
  };
  std::vector<Change> changes_;
  bool in_order_ = true;               ///< one file, lines never falling
  std::vector<ModalSnapshot> states_;  ///< distinct ones, feed left out
};

}  // namespace toolpace
