#pragma once
/// All modes of one axis together.

#include <vector>

#include "toolpace/limits/servo_axis.h"
#include "toolpace/servo/mode.h"

namespace toolpace {

/// The slide's displacement from where its drive has it: Σ share·d of the modes (AxisServo: z − p), exact as these (ModePiece).
class AxisModes {
 public:
  /// @pre the axis is not stiff
  explicit AxisModes(const ServoAxis& axis);

  /// Where the slide is within a piece that begins now.
  double displacement(const AccelerationPolynomial& acceleration, double t) const;
  /// Runs through a piece [s]. The largest |displacement| is found between its samples, too: where its slope changes its sign.
  void run(const AccelerationPolynomial& acceleration, double duration);
  /// A step of the drive's speed [mm/s].
  void step(double speed);

  const std::vector<AxisMode>& modes() const { return modes_; }
  double displacement() const;
  /// Largest |displacement| so far, and when [s] since the begin.
  double peak() const { return peak_; }
  double peak_time() const { return peak_time_; }
  /// Of mode i, share counted, if the drive rests from now on.
  double amplitude(std::size_t i) const { return modes_[i].share * states_[i].amplitude(); }
  /// What the modes can come to together from now on: the sum of their amplitudes, which modes of different frequencies reach or come
  /// near, and a single one has.
  double amplitude() const;

 private:
  ModeState at(const std::vector<ModePiece>& pieces, double t) const;
  void look_for_peak(const std::vector<ModePiece>& pieces, double length);
  void keep(double t, double place);

  std::vector<AxisMode> modes_;
  std::vector<Mode> states_;
  std::vector<ModePiece> pieces_;  ///< of the piece that is run
  double time_ = 0, peak_ = 0, peak_time_ = 0, fastest_ = 0;
};

}  // namespace toolpace
