#pragma once
/// Cuts a planned path into the coloured pieces of a ContourScene. Used by contour_scene.cpp alone.

#include <vector>

#include "preview/contour_scene.h"
#include "toolpace/path/path.h"

namespace toolpace::ui {

class SceneBuilder {
 public:
  SceneBuilder(const Outcome& outcome, ContourScene& scene);

  void build_planned();
  void build_bare();  ///< geometry alone

 private:
  /// Time and distance along a block of the path.
  struct Stretch {
    std::size_t block;
    double begin, end;   ///< [s]
    double entry, exit;  ///< path distance [mm]
  };

  void measure();
  void find_ranges();
  PhaseState state_at(const Phase& phase, double time) const;
  void begin_at(std::size_t node);
  void add_small_block(std::size_t block, double departure);
  void add_block(std::size_t block, double departure);
  void add_stretch(const Phase& phase, const Stretch& stretch);
  int cuts(const Phase& phase, const Stretch& stretch) const;
  void add_piece(const Stretch& stretch, const Eigen::Vector3d& on_path, const PhaseState& mean);
  std::uint8_t level_of(ColourBy by, double value) const;
  std::uint8_t cause_at(double time);
  double error_over(double begin, double end);
  void finish();

  const Outcome& outcome_;
  const Path& path_;
  ContourScene& scene_;
  std::vector<std::uint8_t> style_of_block_;
  double distance_ = 0;                                 ///< path distance at the present block's start [mm]
  double coarse_ = 0;                                   ///< blocks shorter than this are one piece [mm]
  double size_ = 0;                                     ///< of the whole, roughly [mm]
  std::size_t phase_ = 0, restraint_ = 0, sample_ = 0;  ///< cursors that only go forward
};

}  // namespace toolpace::ui
