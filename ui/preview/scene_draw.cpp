#include "preview/scene_draw.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "preview/raster.h"
#include "preview/strokes.h"

namespace toolpace::ui {
namespace {

/// A single point, or a path that is seen end on.
bool is_dot(const ContourScene& scene, const Screen& screen) {
  if (scene.geometry->line.pieces() == 0) return true;
  const Eigen::Vector3d extent = scene.geometry->box.high - scene.geometry->box.low;
  return screen.x.cwiseAbs().dot(extent) < 2 && screen.y.cwiseAbs().dot(extent) < 2;
}

StrokeOptions options_of(const SceneStyle& s) {
  return {s.by, s.colours != nullptr, s.detail, s.cut, s.most_cuts, s.most_pixels};
}

}  // namespace

std::size_t draw_scene(QImage& image, const ContourScene& scene, const Projection& projection,
                       const SceneStyle& style) {
  if (scene.is_empty()) return 0;
  const Screen screen(projection, scene.geometry->centre);
  if (is_dot(scene, screen)) {
    const QPointF at = screen.map(scene.geometry->line.vertex.front());
    LineRaster(image, 4 * style.width, style.smooth).draw(at.x(), at.y(), at.x(), at.y(), style.plain);
    return 1;
  }
  LineRaster lines(image, style.width, style.smooth), thin(image, 1.0, style.smooth);
  double phase = 0;
  const StrokeMaker maker(scene, projection, QRectF(image.rect()).adjusted(-4, -4, 4, 4), options_of(style));
  return maker.make([&](const Stroke& s) {
    if (s.rapid && !style.rapids) return;
    if (s.rapid) {
      phase = thin.draw_dashed(s.from.x(), s.from.y(), s.to.x(), s.to.y(), style.rapid, style.dash, style.dash * 0.8,
                               phase);
    } else if (style.all_dashed) {
      phase = lines.draw_dashed(s.from.x(), s.from.y(), s.to.x(), s.to.y(), style.plain, style.dash, style.dash * 0.7,
                                phase);
    } else {
      const QRgb colour = style.colours && s.shade ? (*style.colours)[*s.shade] : style.plain;
      lines.draw(s.from.x(), s.from.y(), s.to.x(), s.to.y(), colour);
    }
  });
}

void paint_scene(QPainter& painter, const ContourScene& scene, const Projection& projection, const QSizeF& size,
                 const SceneStyle& style) {
  if (scene.is_empty()) return;
  const StrokeMaker maker(scene, projection, QRectF({0, 0}, size).adjusted(-4, -4, 4, 4), options_of(style));
  maker.make([&](const Stroke& s) {
    if (s.rapid && !style.rapids) return;
    const QRgb colour = s.rapid ? style.rapid : style.colours && s.shade ? (*style.colours)[*s.shade] : style.plain;
    painter.setPen(QPen(QColor(colour), s.rapid ? style.width / 2 : style.width, s.rapid ? Qt::DashLine : Qt::SolidLine,
                        Qt::RoundCap));
    painter.drawLine(s.from, s.to);
  });
}

namespace {

/// Gives `line` (from, to) the pieces of a trace, joined where they are shorter than a pixel. @return how many
template <class Line>
std::size_t follow_trace(const ErrorTrace& trace, const Projection& projection, double enlargement, const Line& line) {
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
  QPointF from = at(0);
  std::size_t drawn = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const QPointF to = at(i);
    if (i + 1 < count && std::abs(to.x() - from.x()) + std::abs(to.y() - from.y()) < 0.8) continue;
    line(QPointF(from.x(), from.y()), QPointF(to.x(), to.y()));
    from = to;
    ++drawn;
  }
  return drawn;
}

}  // namespace

std::size_t draw_trace(QImage& image, const ErrorTrace& trace, const Projection& projection, double enlargement,
                       QRgb colour, double width) {
  LineRaster lines(image, width, true);
  return follow_trace(trace, projection, enlargement, [&](const QPointF& from, const QPointF& to) {
    lines.draw(from.x(), from.y(), to.x(), to.y(), colour);
  });
}

std::size_t paint_trace(QPainter& painter, const ErrorTrace& trace, const Projection& projection, double enlargement,
                        QRgb colour, double width) {
  painter.setPen(QPen(QColor(colour), width, Qt::SolidLine, Qt::RoundCap));
  return follow_trace(trace, projection, enlargement,
                      [&](const QPointF& from, const QPointF& to) { painter.drawLine(from, to); });
}

DrawingLoad drawing_load(const ContourScene& scene, const Projection& projection, const QSizeF& size) {
  if (scene.is_empty()) return {};
  return StrokeMaker(scene, projection, QRectF(QPointF(0, 0), size), {}).load();
}

}  // namespace toolpace::ui
