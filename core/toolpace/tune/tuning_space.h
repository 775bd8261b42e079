#pragma once
/// What a tuner may turn, and the jobs that come of it.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// A setting, or two that are turned together: with the acceleration the deceleration, with the jerk that while slowing down, Tdec
/// with Tacc, each pair in the ratio that the job has; with the tolerance of rounded corners the junction deviation.
enum class Knob : std::uint8_t { law, corner, ramps, acceleration, jerk, ramp_time, tolerance, lookahead };
inline constexpr std::size_t kKnobCount = 8;
inline constexpr std::array kAllKnobs = {Knob::law,  Knob::corner,    Knob::ramps,     Knob::acceleration,
                                         Knob::jerk, Knob::ramp_time, Knob::tolerance, Knob::lookahead};

/// "law", "corner", "ramps", "am", "jm", "tacc", "tolerance", "lookahead".
std::string_view knob_name(Knob knob);
std::optional<Knob> knob_named(std::string_view name);
std::string knob_names();

/// A place on each knob.
using Position = std::array<std::uint16_t, kKnobCount>;

/// The jobs that differ from one in what may be turned. Numbers stand on a scale that rises by about 4 % from place to place, each
/// rounded down to three digits, as a person would type them. What is a limit (acceleration, jerk, tolerance, junction deviation,
/// look-ahead) is never above what the job has, and a law without a jerk limit is none to try where there is one to keep.
class TuningSpace {
 public:
  /// What is not in `turned` stays as the job has it, and so does what makes no difference there, such as a limit that nothing
  /// bounds, or the corner rule under a corner step.
  TuningSpace(std::shared_ptr<const Job> job, std::span<const Knob> turned);

  /// The job's own settings.
  const Position& home() const { return home_; }
  std::size_t places(Knob knob) const { return scale(knob).size(); }
  /// Whether places are a list of choices; else they are in order, rising.
  static bool is_choice(Knob knob);
  /// Where a place of a number is, from 0 to about 1 along its scale.
  double coordinate(Knob knob, std::size_t place) const { return scale(knob)[place].coordinate; }

  /// The position that stands for all that give the same job: knobs that mean nothing beside the others are at home.
  Position canonical(const Position& position) const;
  std::shared_ptr<const Job> job_at(const Position& position) const;
  /// Whether planning there takes many times as long as elsewhere: a motion through the tolerance tube is looked for.
  bool is_dear(const Position& position) const;

 private:
  struct Place {
    double value;  ///< the choice's number, a share of the job's own value, or blocks
    double coordinate;
  };
  using Scale = std::vector<Place>;
  const Scale& scale(Knob knob) const { return scales_[static_cast<std::size_t>(knob)]; }
  void add_choices(Knob knob);
  void add_numbers(Knob knob);
  void add_depths();
  double value_at(const Position& position, Knob knob) const;
  bool is_home(const Position& position, Knob knob) const;

  std::shared_ptr<const Job> job_;
  std::array<Scale, kKnobCount> scales_;
  Position home_ = {};
};

}  // namespace toolpace
