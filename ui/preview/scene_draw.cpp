#include "preview/scene_draw.h"

#include <algorithm>
#include <cmath>

#include "preview/raster.h"

namespace toolpace::ui {
namespace {

/// A projection with everything multiplied out, for vertices relative to the scene's centre.
struct Screen {
  Eigen::Vector3d x, y;  // px a mm
  double x0, y0;         // px

  Screen(const Projection& p, const Eigen::Vector3d& centre)
      : x(p.scale * p.right),
        y(-p.scale * p.up),
        x0(p.origin.x() + x.dot(centre - p.pivot)),
        y0(p.origin.y() + y.dot(centre - p.pivot)) {}

  QPointF map(const Eigen::Vector3f& v) const {
    const Eigen::Vector3d d = v.cast<double>();
    return {x0 + x.dot(d), y0 + y.dot(d)};
  }
  bool meets(const ChunkBox& box, const QRectF& rectangle) const {
    const Eigen::Vector3d middle = (box.low + box.high).cast<double>() / 2;
    const Eigen::Vector3d half = (box.high - box.low).cast<double>() / 2;
    const double half_x = x.cwiseAbs().dot(half), half_y = y.cwiseAbs().dot(half);
    const double cx = x0 + x.dot(middle), cy = y0 + y.dot(middle);
    return cx + half_x >= rectangle.left() && cx - half_x <= rectangle.right() && cy + half_y >= rectangle.top() &&
           cy - half_y <= rectangle.bottom();
  }
};

const LodLevel* level_for(const ContourScene& scene, const Projection& projection, double detail) {
  if (scene.lod.levels.empty()) return nullptr;
  return &scene.lod.levels[scene.lod.level_for(detail / projection.scale)];
}

class Painter {
 public:
  Painter(QImage& image, const ContourScene& scene, const SceneStyle& style)
      : scene_(scene), style_(style), lines_(image, style.width, style.smooth), thin_(image, 1.0, style.smooth) {}

  void chunk(const LodLevel& level, const Screen& screen, std::size_t first, std::size_t last) {
    const auto by = static_cast<std::size_t>(style_.by);
    const auto& colour_level = level.is_full() ? scene_.line.level[by] : level.level[by];
    const bool coloured = style_.colours && !colour_level.empty();
    const auto vertex = [&](std::size_t j) { return level.is_full() ? j : level.vertex[j]; };
    QPointF from = screen.map(scene_.line.vertex[vertex(first)]);
    for (std::size_t j = first; j < last; ++j) {
      const QPointF to = screen.map(scene_.line.vertex[vertex(j + 1)]);
      const bool rapid = scene_.line.style[vertex(j)] == static_cast<std::uint8_t>(PieceStyle::rapid);
      if (rapid) {
        phase_ =
            thin_.draw_dashed(from.x(), from.y(), to.x(), to.y(), style_.rapid, style_.dash, style_.dash * 0.8, phase_);
      } else {
        draw(from, to, coloured ? (*style_.colours)[colour_level[j]] : style_.plain);
      }
      from = to;
    }
  }

 private:
  void draw(const QPointF& from, const QPointF& to, QRgb colour) {
    if (style_.all_dashed) {
      phase_ = lines_.draw_dashed(from.x(), from.y(), to.x(), to.y(), colour, style_.dash, style_.dash * 0.7, phase_);
    } else {
      lines_.draw(from.x(), from.y(), to.x(), to.y(), colour);
    }
  }

  const ContourScene& scene_;
  const SceneStyle& style_;
  LineRaster lines_, thin_;
  double phase_ = 0;
};

std::size_t pieces_of(const ContourScene& scene, const LodLevel& level) {
  return level.is_full() ? scene.line.pieces() : level.vertex.size() - 1;
}

/// A single point, or a path that is seen end on.
bool is_dot(const ContourScene& scene, const Screen& screen) {
  if (scene.line.pieces() == 0) return true;
  const Eigen::Vector3d extent = scene.box.high - scene.box.low;
  return screen.x.cwiseAbs().dot(extent) < 2 && screen.y.cwiseAbs().dot(extent) < 2;
}

}  // namespace

std::size_t draw_scene(QImage& image, const ContourScene& scene, const Projection& projection,
                       const SceneStyle& style) {
  const LodLevel* level = level_for(scene, projection, style.detail);
  if (!level || scene.is_empty()) return 0;
  const Screen screen(projection, scene.centre);
  if (is_dot(scene, screen)) {
    const QPointF at = screen.map(scene.line.vertex.front());
    LineRaster(image, 4 * style.width, style.smooth).draw(at.x(), at.y(), at.x(), at.y(), style.plain);
    return 1;
  }
  const QRectF window = QRectF(image.rect()).adjusted(-4, -4, 4, 4);
  const std::size_t pieces = pieces_of(scene, *level);
  Painter painter(image, scene, style);
  std::size_t drawn = 0;
  for (std::size_t c = 0; c < level->boxes.size(); ++c) {
    if (!screen.meets(level->boxes[c], window)) continue;
    const std::size_t first = c * kChunk, last = std::min(first + kChunk, pieces);
    painter.chunk(*level, screen, first, last);
    drawn += last - first;
  }
  return drawn;
}

std::size_t draw_trace(QImage& image, const ErrorTrace& trace, const Projection& projection, double enlargement,
                       QRgb colour, double width) {
  const std::size_t count = std::min(trace.commanded.size(), trace.offset.size());
  if (count < 2) return 0;
  const Screen screen(projection, Eigen::Vector3d::Zero());
  const auto at = [&](std::size_t i) {
    const Eigen::Vector3f way = trace.commanded[std::min(i + 1, count - 1)] - trace.commanded[i > 0 ? i - 1 : 0];
    const float length = way.squaredNorm();
    Eigen::Vector3f across = trace.offset[i];
    if (length > 0) across -= across.dot(way) / length * way;
    return screen.map(trace.commanded[i] + static_cast<float>(enlargement) * across);
  };
  LineRaster lines(image, width, true);
  QPointF from = at(0);
  std::size_t drawn = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const QPointF to = at(i);
    if (i + 1 < count && std::abs(to.x() - from.x()) + std::abs(to.y() - from.y()) < 0.8) continue;
    lines.draw(from.x(), from.y(), to.x(), to.y(), colour);
    from = to;
    ++drawn;
  }
  return drawn;
}

std::size_t visible_pieces(const ContourScene& scene, const Projection& projection, const QSizeF& size) {
  const LodLevel* level = level_for(scene, projection, SceneStyle{}.detail);
  if (!level) return 0;
  const Screen screen(projection, scene.centre);
  const QRectF window(QPointF(0, 0), size);
  const auto chunks = static_cast<std::size_t>(std::count_if(
      level->boxes.begin(), level->boxes.end(), [&](const ChunkBox& box) { return screen.meets(box, window); }));
  return std::min(chunks * kChunk, pieces_of(scene, *level));
}

std::vector<std::pair<std::size_t, std::size_t>> runs_near(const ContourScene& scene, const Projection& projection,
                                                           const QRectF& rectangle) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  if (scene.lod.levels.empty()) return runs;
  const Screen screen(projection, scene.centre);
  const auto& boxes = scene.lod.levels.front().boxes;
  for (std::size_t c = 0; c < boxes.size(); ++c) {
    if (!screen.meets(boxes[c], rectangle)) continue;
    runs.emplace_back(c * kChunk, std::min((c + 1) * kChunk, scene.line.pieces()));
  }
  return runs;
}

std::optional<Pick> pick(const ContourScene& scene, const Projection& projection, const QPointF& at, double radius) {
  const Screen screen(projection, scene.centre);
  const QRectF near(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
  std::optional<Pick> best;
  for (const auto& [first, last] : runs_near(scene, projection, near)) {
    QPointF from = screen.map(scene.line.vertex[first]);
    for (std::size_t i = first; i < last; ++i) {
      const QPointF to = screen.map(scene.line.vertex[i + 1]);
      const QPointF along = to - from, off = at - from;
      const double length = QPointF::dotProduct(along, along);
      const double fraction = length > 0 ? std::clamp(QPointF::dotProduct(off, along) / length, 0.0, 1.0) : 0.0;
      const QPointF gap = off - fraction * along;
      const double distance = std::sqrt(QPointF::dotProduct(gap, gap));
      if (distance <= radius && (!best || distance <= best->distance)) {
        best = Pick{i, fraction, scene.time[i] + fraction * (scene.time[i + 1] - scene.time[i]), distance};
      }
      from = to;
    }
  }
  return best;
}

}  // namespace toolpace::ui
