#pragma once
/// How long a real controller takes for a program, and why.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/controller/program_text.h"
#include "toolpace/machine/controller_settings.h"
#include "toolpace/nc/reading.h"

namespace toolpace {

/// What holds a controller's motion down, or up.
enum class TimeLimit : std::uint8_t {
  feed,          ///< of the program
  rapid,         ///< rapids at the speed of the axes
  axis_speed,    ///< feed moves at the speed of the axes or the path, below what is programmed
  acceleration,  ///< speeding up, and slowing down for a lower speed
  corner,        ///< slowing down for a corner, or on a curve
  buffer,        ///< slowing down for the end of what the look-ahead holds
  link,          ///< slowing down or resting because blocks have not come yet
  stops,         ///< slowing down to a stop of the program, and what the controller does at one
  dwell
};
inline constexpr std::size_t kTimeLimitCount = 9;

/// "feed", …: the keys of time_by_limit_s.
std::string_view time_limit_name(TimeLimit limit);

struct PredictOptions {
  std::optional<double> baud;        ///< [bit/s] of a serial link, 10 bits a byte; none = blocks are always there
  std::optional<double> block_time;  ///< [s] that the controller needs to read a block; none = 0
  bool keeps_blocks = false;         ///< fills Prediction::row_time
  bool keeps_motion = false;         ///< fills Prediction::stages
};

/// A while in which the acceleration along the controller's own way (chords of arcs) is constant, or of rest.
struct Stage {
  double duration;    ///< [s] > 0
  double from, to;    ///< speeds [mm/s]; 0 and 0 at rest
  std::uint32_t row;  ///< of the moves
  TimeLimit limit;    ///< what holds it down, or up
};

/// Times are from the first step of motion to the last, pauses included.
struct Prediction {
  Controller controller = Controller::grbl;
  std::size_t blocks = 0;  ///< planned by the controller: chords of arcs are blocks of their own
  double cycle_time = 0, feed_time = 0, rapid_time = 0, dwell_time = 0;  ///< [s]
  double starved = 0;                                      ///< [s] lost because blocks did not arrive in time
  std::array<double, kTimeLimitCount> time_by_limit = {};  ///< [s]
  std::vector<double> row_time;                            ///< [s] of each row of the moves
  std::vector<Stage> stages;                               ///< one after the other; none of LinuxCNC, which blends
  Diagnostics warnings;
};

/// Predicts a program on the controller whose settings these are. The same input gives the same bytes.
///
/// Memory does not grow with the program, but for row_time and stages, where they are asked for.
/// @param reading   in the controller's dialect (dialect_of())
/// @param text      of the same program
/// @return input errors: a move that the controller refuses; cancelled
Result<Prediction> predict(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                           const PredictOptions& options = {}, const Monitor& monitor = {});

/// Warnings of what no model counts: moves of extruders.
Diagnostics not_counted(const ProgramText& text, const ControllerSettings& settings, const std::string& program_name);

/// The dialect that a controller reads programs in.
Dialect dialect_of(Controller controller);

}  // namespace toolpace
