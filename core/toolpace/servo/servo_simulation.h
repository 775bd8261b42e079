#pragma once
/// Setpoints -> where the machine really goes.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/servo_axis.h"
#include "toolpace/sample/setpoints.h"
#include "toolpace/servo/axis_servo.h"
#include "toolpace/servo/contour_error.h"

namespace toolpace {

using ServoMachine = std::array<ServoAxis, kAxisCount>;

/// Row k belongs to row k of the setpoints.
struct ServoTrace {
  std::array<std::vector<double>, kAxisCount> actual;  ///< [mm, rad]; empty where the setpoints have no column
  std::vector<double> lag;                             ///< commanded to actual point [mm]
  std::vector<double> contour_error;                   ///< actual point to commanded path [mm]
};

struct ServoSummary {
  std::size_t rows = 0;
  double max_contour_error = 0.0, rms_contour_error = 0.0;  ///< [mm]
  double max_lag = 0.0, rms_lag = 0.0;                      ///< [mm]
  std::size_t worst_row = 0;                                ///< of the contour error
  double worst_time = 0.0;                                  ///< [s]
  std::uint32_t worst_line = 0;                             ///< NC line
  double settling_time =
      0.0;  ///< [s] after the last setpoint until the lag stays below 1 µm and the play (at most 10 s looked at)
};

/// Simulates the drives while setpoints go by, in bounded memory.
class ServoSimulation {
 public:
  /// Errors: of AxisServo::create.
  static Result<ServoSimulation> create(const ServoMachine& machine, double period);

  /// Takes the next rows; appends what can be measured already to `trace` (it stays some rows behind).
  void take(const Setpoints& chunk, ServoTrace& trace);
  /// The rest of the rows.
  ServoSummary finish(ServoTrace& trace);

 private:
  ServoSimulation() = default;
  void step_axis(std::size_t axis, const std::vector<double>& commanded, std::vector<double>& actual);
  void hand_out(bool all, ServoTrace& trace);
  double settle();

  double period_ = 0.0;
  std::vector<AxisServo> servos_;
  std::vector<double> play_;  ///< [mm, rad]
  std::array<double, kAxisCount> last_ = {}, before_last_ = {};
  std::array<bool, kAxisCount> used_ = {};
  bool started_ = false;
  ContourMeter meter_;
  std::vector<ContourMeter::Row> rows_;
  std::vector<std::uint32_t> lines_;  ///< of rows not yet handed out
  double sum_contour_ = 0.0, sum_lag_ = 0.0;
  ServoSummary summary_;
};

/// The whole of some setpoints at once.
struct ServoResult {
  ServoTrace trace;
  ServoSummary summary;
};
Result<ServoResult> simulate_servo(const Setpoints& setpoints, const ServoMachine& machine);

}  // namespace toolpace
