#include "drawing/scene_geometry.h"

#include <algorithm>
#include <cmath>

#include "toolpace/sample/motion.h"

namespace toolpace::ui {
namespace {

constexpr double kSmallestChordError = 2500;        // part of the whole: enlarged further, curves are drawn as such
constexpr int kMostChords = 4096;                   // of one curve
constexpr double kFinest = 32768, kCoarsest = 256;  // levels of detail, as parts of the whole

class GeometryBuilder {
 public:
  explicit GeometryBuilder(const Outcome& outcome)
      : outcome_(outcome), path_(*outcome.path), motion_(path_, outcome.plan) {
    geometry_.path = outcome.path;
    measure();
    mark_styles();
  }

  SceneGeometry build() {
    add_vertex(path_.node.front().head<3>());
    outcome_.plan.splines.empty() ? follow_path() : follow_motion();
    measure_feeds();
    const double size = geometry_.box.diagonal() > 0 ? geometry_.box.diagonal() : 1.0;
    geometry_.lod = build_lod(geometry_.line, size / kFinest, size / kCoarsest);
    return std::move(geometry_);
  }

 private:
  void measure() {
    Box box;
    for (const auto& node : path_.node) box.add(node.head<3>());
    for (const auto& arc : path_.arcs) {
      const double radius = std::max(arc.start_radius, arc.end_radius);
      box.add(arc.centre.array() - radius);
      box.add(arc.centre.array() + radius);
    }
    size_ = box.diagonal();
    geometry_.centre = box.centre();
  }

  void mark_styles() {
    style_of_block_.assign(path_.size(), static_cast<std::uint8_t>(PieceStyle::feed));
    if (!outcome_.job || !outcome_.job->program) return;
    const auto& kinds = outcome_.job->program->moves.kind;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (path_.move[i] < kinds.size() && kinds[path_.move[i]] == MoveKind::rapid) {
        style_of_block_[i] = static_cast<std::uint8_t>(PieceStyle::rapid);
      }
    }
  }

  int chords(std::size_t block) const {
    if (path_.kind[block] == SegmentKind::line) return 1;
    if (path_.kind[block] != SegmentKind::arc) return 16;
    const auto& arc = path_.arcs[path_.detail[block]];
    const double radius = std::max({arc.start_radius, arc.end_radius, 1e-300});
    const double step = 2 * std::acos(std::clamp(1 - size_ / kSmallestChordError / radius, 0.5, 1 - 1e-6));
    return static_cast<int>(std::clamp(std::ceil(arc.sweep / step), 1.0, double{kMostChords}));
  }

  void follow_path() {
    const bool has_curves =
        std::any_of(path_.kind.begin(), path_.kind.end(), [](SegmentKind kind) { return kind != SegmentKind::line; });
    if (!has_curves) {
      geometry_.line.style = std::move(style_of_block_);
      geometry_.line.vertex.reserve(path_.node.size());
      for (std::size_t i = 1; i < path_.node.size(); ++i) add_vertex(path_.node[i].head<3>());
      return;
    }
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const int count = chords(i);
      for (int k = 1; k < count; ++k) {
        const double share = static_cast<double>(k) / count;
        add_piece(i, share, point_at(path_, i, path_.length[i] * share).head<3>());
      }
      add_piece(i, 1.0, path_.node[i + 1].head<3>());
    }
  }

  /// Off the path only the motion itself tells where the tool is: a piece for each phase, or chord of a curve.
  void follow_motion() {
    geometry_.time.push_back(outcome_.node_time.front());
    const auto& phases = outcome_.plan.phases;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const double arrival = outcome_.node_time[i + 1];
      double time = outcome_.node_time[i];
      while (time < arrival) {
        const std::size_t phase = motion_.at(time).phase();
        const double until = phase + 1 < phases.size() ? std::min(phases[phase + 1].begin, arrival) : arrival;
        const int count = motion_.at((time + until) / 2).leaves_path() ? 1 : chords(i);
        for (int k = 1; k <= count; ++k) add_moment(i, k == count ? until : time + (until - time) * k / count);
        time = until;
      }
    }
  }

  void add_moment(std::size_t block, double time) {
    motion_.at(time, block);
    add_piece(block, motion_.on_segment() / path_.length[block], motion_.place().head<3>());
    geometry_.time.push_back(time);
  }

  void add_piece(std::size_t block, double share, const Eigen::Vector3d& to) {
    add_vertex(to);
    geometry_.line.style.push_back(style_of_block_[block]);
    geometry_.block.push_back(static_cast<std::uint32_t>(block));
    geometry_.share.push_back(static_cast<float>(share));
  }

  /// Where nothing but rapids is left away. @pre the line is whole
  void measure_feeds() {
    const auto& style = geometry_.line.style;
    for (std::size_t i = 0; i < style.size(); ++i) {
      if (style[i] == static_cast<std::uint8_t>(PieceStyle::rapid)) continue;
      geometry_.feed_box.add(geometry_.point(i));
      geometry_.feed_box.add(geometry_.point(i + 1));
    }
  }

  void add_vertex(const Eigen::Vector3d& point) {
    geometry_.line.vertex.push_back((point - geometry_.centre).cast<float>());
    geometry_.box.add(point);
  }

  const Outcome& outcome_;
  const Path& path_;
  Motion motion_;
  SceneGeometry geometry_;
  std::vector<std::uint8_t> style_of_block_;
  double size_ = 0;  // of the whole, roughly [mm]
};

}  // namespace

bool fits(const SceneGeometry& geometry, const Outcome& outcome) {
  return geometry.path && geometry.path == outcome.path && geometry.time.empty() && outcome.plan.splines.empty();
}

std::shared_ptr<const SceneGeometry> make_scene_geometry(const Outcome& outcome) {
  if (!outcome.path || outcome.path->node.empty()) return std::make_shared<SceneGeometry>();
  return std::make_shared<const SceneGeometry>(GeometryBuilder(outcome).build());
}

}  // namespace toolpace::ui
