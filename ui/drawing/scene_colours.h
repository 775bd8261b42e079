#pragma once
/// The speed-dependent part of the preview: a shade (0 … 255) for each piece, made when it is first asked for.

#include <array>
#include <map>
#include <mutex>
#include <optional>

#include "drawing/scene_geometry.h"

#include "toolpace/law/phase_bounds.h"

namespace toolpace::ui {

enum class ColourBy : std::uint8_t { speed, acceleration, jerk, limit, contour_error };
inline constexpr std::size_t kColourings = 5;
/// Values on both sides of zero, which want a map that tells the sides apart.
constexpr bool is_signed(ColourBy by) { return by == ColourBy::acceleration || by == ColourBy::jerk; }

/// Where the tool really went, as a drive simulation found it.
struct ErrorTrace {
  std::vector<double> time;                ///< [s], ascending
  std::vector<float> error;                ///< contour error [mm], ≥ 0
  std::vector<Eigen::Vector3f> commanded;  ///< where it was asked to be [mm]
  std::vector<Eigen::Vector3f> offset;     ///< actual minus commanded position at that time [mm]
};

/// A stretch of the path as it is run.
struct Stretch {
  double begin, end;  ///< [s]
  double length;      ///< [mm]
};

/// Safe to ask from several threads. What it is made of must outlive it.
class SceneColours {
 public:
  SceneColours(const Outcome& outcome, const SceneGeometry& geometry, const ErrorTrace* trace);

  bool has(ColourBy by) const;
  /// Values at shade 0 and at shade 255 [mm, s]. Rapids are drawn without colour, so the scale belongs to the feeds; a
  /// program of rapids alone has it for itself.
  Interval range(ColourBy by) const;
  /// One a piece of a level of detail; shades of ColourBy::limit are causes. Precondition: has(by).
  const std::vector<std::uint8_t>& shades(ColourBy by, std::size_t level = 0) const;
  /// The mean over a stretch; of contour errors the worst, which a mean would hide at a corner.
  std::uint8_t shade(ColourBy by, const Stretch& stretch) const;
  /// When the tool comes to a share 0 … 1 of a segment [s].
  double time_at(std::size_t block, double share) const;
  /// The part of a piece between two shares of the piece itself, as it is run.
  Stretch stretch(std::size_t piece, double from, double to) const;

 private:
  using Shades = std::vector<std::uint8_t>;
  std::array<Interval, kColourings> find_ranges() const;
  std::uint8_t scaled(ColourBy by, double value) const;
  Shades make_full(ColourBy by) const;
  double worst_error(double begin, double end) const;

  const Outcome& outcome_;
  const SceneGeometry& geometry_;
  const ErrorTrace* trace_;
  mutable std::recursive_mutex mutex_;
  mutable std::optional<std::array<Interval, kColourings>> ranges_;
  mutable std::array<std::map<std::size_t, Shades>, kColourings> shades_;  // by level
};

}  // namespace toolpace::ui
