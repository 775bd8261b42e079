#pragma once
/// A segment in LinuxCNC's queue of motion.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "toolpace/controller/prediction.h"

namespace toolpace::detail::controller {

enum class Ending : std::uint8_t { stop, exact, tangent, parabolic };
enum class Shape : std::uint8_t { line, arc, blend };  ///< blend: an arc that rounds a corner

/// Shares of a segment's acceleration. @source LinuxCNC 2.9, tp_types.h
inline constexpr double kNormalShare = 0.866, kTangentialShare = 0.5;

struct Segment {
  Shape shape = Shape::line;
  Ending ending = Ending::parabolic;
  bool is_rapid = false, has_rotary = false;
  bool blends_before = false;  ///< a parabolic blend leads into it
  bool is_final = false;       ///< its length changes no more
  std::uint32_t row = 0;
  double length = 0;      ///< [mm] now
  double programmed = 0;  ///< [mm] before corners took of it
  double wanted = 0;      ///< [mm/s] of the program
  double top = 0;         ///< [mm/s] most
  double acceleration = 0;
  double tangential = 1;   ///< share of the acceleration that is left along an arc
  double kink_speed = -1;  ///< [mm/s] at its end where that is passed as if it were tangent; −1 = not known
  double kink_loss = 0, kink_loss_before = 0;  ///< shares of the acceleration that kinks at its ends take
  double tolerance = 0;                        ///< [mm] of G64 P; 0 = none
  Eigen::Vector3d start_tangent, end_tangent, start_pull, end_pull;  ///< pull: of acceleration, with that of an arc
  Eigen::Vector3d from, to;
  Eigen::Vector3d centre, normal;  ///< of an arc; normal so that it turns counter-clockwise
  double radius = 0, sweep = 0;    ///< of an arc [mm, rad]
  double bend = 0;                 ///< [mm] the radius that counts for its speed; a helix' is larger
  TimeLimit cruise = TimeLimit::feed;

  // While it runs:
  double progress = 0, speed = 0, blend_speed = 0, end_speed = 0;
  double cycle = 0;   ///< [s] of its next step
  double final = -1;  ///< [mm/s] that the look-ahead lets it end with; −1 = not known
  bool is_active = false, is_splitting = false, is_done = false, slows_down = false, blends_next = false,
       is_ramp = false;

  bool is_round() const { return shape != Shape::line; }

  /// All of it, and what is left along the path. Where blends are parabolic two segments share the acceleration.
  double overall_acceleration() const {
    const double part = 1.0 - std::max(kink_loss, kink_loss_before);
    return acceleration * part * (blends_before || ending == Ending::parabolic ? 0.5 : 1.0);
  }
  double path_acceleration() const { return overall_acceleration() * (is_round() ? tangential : 1.0); }
  /// @param scale  of what is programmed
  double target(double scale = 1.0) const { return std::min(wanted * scale, top); }
};

/// How LinuxCNC joins two segments that follow each other.
struct JointLimits {
  Eigen::Vector3d axis_acceleration, axis_velocity;
  double cycle = 0.001;     ///< [s]
  double kink_ratio = 0.1;  ///< share of the acceleration that a kink may take
  double feed_scale = 1;    ///< corners are laid out for this much of the programmed feed
  double gap_cycles = 4;    ///< a line shorter than these becomes part of the blend behind it
  bool arc_blends = true;
};

/// Settles how `before` ends and `next` begins; what is rounded is cut off both. `next` was not queued yet.
///
/// @param blend  filled where an arc rounds the corner
/// @param consumed  set where the arc takes all of `before`
/// @return whether there is a blend to be queued between them
/// @source LinuxCNC 2.9, emc/tp: what it does, in other words
bool join(Segment& before, Segment& next, const JointLimits& limits, Segment& blend, bool& consumed);

/// Speeds at which a parabolic blend begins in `a` and ends in `b`, and their mean along it.
struct ParabolicSpeeds {
  double first, second, net;
};
ParabolicSpeeds parabolic_speeds(const Segment& a, const Segment& b, double scale = 1.0);

/// Its length changes no more: what follows from it.
void finalize(Segment& segment, double cycle);

}  // namespace toolpace::detail::controller
