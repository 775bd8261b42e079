#include "preview/scene_pick.h"

#include <algorithm>
#include <cmath>

#include "preview/strokes.h"

namespace toolpace::ui {

std::vector<DirectionMark> direction_marks(const ContourScene& scene, const Projection& projection, const QSizeF& size,
                                           double apart, std::size_t most) {
  constexpr std::size_t kMostPieces = 20'000;
  constexpr double kMostInk = 0.15;  // px of path a px² of the window: lines 7 px apart
  std::vector<DirectionMark> marks;
  if (scene.is_empty() || most == 0) return marks;
  const QRectF window({0, 0}, size);
  const StrokeMaker maker(scene, projection, window, {});
  if (maker.visible() > kMostPieces) return marks;
  const auto visit = [&](const auto& take) {
    maker.make([&](const Stroke& s) {
      const auto [begin, end] = inside(s.from, s.to, window);
      const QPointF way = s.to - s.from;
      const double length = std::hypot(way.x(), way.y());
      if (!s.rapid && end > begin && length > 0) take(s.from, way / length, begin * length, end * length);
    });
  };
  double sum = 0;
  visit([&](const QPointF&, const QPointF&, double begin, double end) { sum += end - begin; });
  if (sum > kMostInk * size.width() * size.height()) return marks;
  const double step = std::max(apart, sum / static_cast<double>(most));
  double left = step / 2;
  // Passes above each other would wear their arrows in heaps.
  const auto has_room = [&](const QPointF& at) {
    return std::none_of(marks.begin(), marks.end(), [&](const DirectionMark& m) {
      return std::hypot(m.at.x() - at.x(), m.at.y() - at.y()) < apart / 4;
    });
  };
  visit([&](const QPointF& from, const QPointF& way, double begin, double end) {
    for (begin += left; begin < end; begin += step) {
      const QPointF at = from + begin * way;
      if (has_room(at)) marks.push_back({at, way});
    }
    left = begin - end;
  });
  return marks;
}

std::vector<std::pair<std::size_t, std::size_t>> runs_near(const ContourScene& scene, const Projection& projection,
                                                           const QRectF& rectangle) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  if (scene.is_empty()) return runs;
  const Screen screen(projection, scene.geometry->centre);
  const auto& boxes = scene.geometry->lod.levels.front().boxes;
  for (std::size_t c = 0; c < boxes.size(); ++c) {
    if (!screen.meets(boxes[c], rectangle)) continue;
    runs.emplace_back(c * kChunk, std::min((c + 1) * kChunk, scene.geometry->line.pieces()));
  }
  return runs;
}

std::optional<Pick> pick(const ContourScene& scene, const Projection& projection, const QPointF& at, double radius,
                         bool rapids) {
  const Screen screen(projection, scene.geometry->centre);
  const auto& vertex = scene.geometry->line.vertex;
  const QRectF near(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
  std::optional<Pick> best;
  for (const auto& [first, last] : runs_near(scene, projection, near)) {
    QPointF from = screen.map(vertex[first]);
    for (std::size_t i = first; i < last; ++i) {
      const QPointF to = screen.map(vertex[i + 1]);
      if (!rapids && scene.geometry->line.style[i] == static_cast<std::uint8_t>(PieceStyle::rapid)) {
        from = to;
        continue;
      }
      const QPointF along = to - from, off = at - from;
      const double length = QPointF::dotProduct(along, along);
      const double fraction = length > 0 ? std::clamp(QPointF::dotProduct(off, along) / length, 0.0, 1.0) : 0.0;
      const QPointF gap = off - fraction * along;
      const double distance = std::sqrt(QPointF::dotProduct(gap, gap));
      if (distance <= radius && (!best || distance <= best->distance)) best = Pick{i, fraction, 0.0, distance};
      from = to;
    }
  }
  if (best && scene.colours) best->time = scene.colours->stretch(best->piece, 0, best->fraction).end;
  return best;
}

}  // namespace toolpace::ui
