#include "preview/scene_draw.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "preview/raster.h"
#include "toolpace/path/path.h"

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

struct StrokeOptions {
  ColourBy by = ColourBy::speed;
  bool coloured = false;
  double detail = SceneStyle{}.detail;
  double cut = 4;
  std::size_t most_cuts = 0;
};

/// A piece of the path on the screen, in one colour.
struct Stroke {
  QPointF from, to;
  std::optional<std::uint8_t> shade;  // nothing: no colour is known
  bool rapid;
};

/// The share of a line that lies in a rectangle; begin > end if none does.
/// @source Liang, Barsky 1984
std::pair<double, double> inside(const QPointF& from, const QPointF& to, const QRectF& window) {
  const QPointF d = to - from;
  double begin = 0, end = 1;
  const auto cut = [&](double towards, double room) {
    if (towards == 0) {
      if (room < 0) begin = 2;
    } else if (towards < 0) {
      begin = std::max(begin, room / towards);
    } else {
      end = std::min(end, room / towards);
    }
  };
  cut(-d.x(), from.x() - window.left());
  cut(d.x(), window.right() - from.x());
  cut(-d.y(), from.y() - window.top());
  cut(d.y(), window.bottom() - from.y());
  return {begin, end};
}

/// Cuts what can be seen of a scene into strokes of one colour each. Pieces that are long on the screen are cut where
/// they are seen, so that colours follow the plan, and lines the curve, at any enlargement.
class StrokeMaker {
 public:
  StrokeMaker(const ContourScene& scene, const Projection& projection, const QRectF& window,
              const StrokeOptions& options)
      : scene_(scene),
        geometry_(*scene.geometry),
        options_(options),
        window_(window),
        screen_(projection, geometry_.centre),
        index_(geometry_.lod.level_for(options.detail / projection.scale)),
        level_(geometry_.lod.levels[index_]) {
    if (options.coloured && scene.can_colour_by(options.by)) shades_ = &scene.colours->shades(options.by, index_);
    for (std::size_t c = 0; c < level_.boxes.size(); ++c) {
      if (screen_.meets(level_.boxes[c], window)) chunks_.push_back(c);
    }
    step_ = step();
  }

  std::size_t pieces() const { return level_.is_full() ? geometry_.line.pieces() : level_.vertex.size() - 1; }
  std::size_t visible() const { return std::min(chunks_.size() * kChunk, pieces()); }

  template <class Take>
  std::size_t make(const Take& take) const {
    std::size_t drawn = 0;
    for_each_piece([&](std::size_t j, const QPointF& from, const QPointF& to) {
      const std::size_t i = level_.at(j);
      Stroke stroke{from, to, std::nullopt, geometry_.line.style[i] == static_cast<std::uint8_t>(PieceStyle::rapid)};
      if (shades_) stroke.shade = (*shades_)[j];
      ++drawn;
      if (step_ > 0 && level_.at(j + 1) == i + 1 && refine(i, stroke, take)) return;
      take(stroke);
    });
    return drawn;
  }

 private:
  template <class Visit>
  void for_each_piece(const Visit& visit) const {
    const std::size_t count = pieces();
    for (const std::size_t c : chunks_) {
      const std::size_t first = c * kChunk, last = std::min(first + kChunk, count);
      QPointF from = screen_.map(geometry_.line.vertex[level_.at(first)]);
      for (std::size_t j = first; j < last; ++j) {
        const QPointF to = screen_.map(geometry_.line.vertex[level_.at(j + 1)]);
        visit(j, from, to);
        from = to;
      }
    }
  }

  /// Length of a cut [px]: as short as the budget allows; 0 = nothing is cut.
  double step() const {
    if (!shades_ || options_.most_cuts == 0 || chunks_.size() * kChunk > 2 * options_.most_cuts) return 0;
    double sum = 0;
    for_each_piece([&](std::size_t, const QPointF& from, const QPointF& to) {
      const auto [begin, end] = inside(from, to, window_);
      if (end > begin) sum += (end - begin) * std::hypot(to.x() - from.x(), to.y() - from.y());
    });
    return std::max(options_.cut, sum / static_cast<double>(options_.most_cuts));
  }

  template <class Take>
  bool refine(std::size_t piece, const Stroke& whole, const Take& take) const {
    const auto [begin, end] = inside(whole.from, whole.to, window_);
    const QPointF way = whole.to - whole.from;
    const double pixels = (end - begin) * std::hypot(way.x(), way.y());
    if (!(end > begin) || !(pixels > 1.5 * step_)) return false;
    const int count = static_cast<int>(std::min(std::ceil(pixels / step_), 8192.0));
    Stroke stroke = whole;
    stroke.from = place(piece, whole, begin);
    double share = begin;
    for (int k = 1; k <= count; ++k) {
      const double next = begin + (end - begin) * k / count;
      stroke.to = place(piece, whole, next);
      if (!whole.rapid) stroke.shade = scene_.colours->shade(options_.by, scene_.colours->stretch(piece, share, next));
      take(stroke);
      stroke.from = stroke.to;
      share = next;
    }
    return true;
  }

  /// The point of a piece at a share of it.
  QPointF place(std::size_t piece, const Stroke& whole, double share) const {
    const std::size_t block = geometry_.block_of(piece);
    const Path& path = *scene_.outcome->path;
    if (path.kind[block] == SegmentKind::line || !geometry_.time.empty() || share <= 0 || share >= 1) {
      return whole.from + share * (whole.to - whole.from);
    }
    const double before = geometry_.share_before(piece), after = geometry_.share_after(piece);
    const double along = path.length[block] * (before + (after - before) * share);
    return screen_.map((point_at(path, block, along).head<3>() - geometry_.centre).cast<float>());
  }

  const ContourScene& scene_;
  const SceneGeometry& geometry_;
  StrokeOptions options_;
  QRectF window_;
  Screen screen_;
  std::size_t index_;
  const LodLevel& level_;
  const std::vector<std::uint8_t>* shades_ = nullptr;
  std::vector<std::size_t> chunks_;
  double step_ = 0;
};

/// A single point, or a path that is seen end on.
bool is_dot(const ContourScene& scene, const Screen& screen) {
  if (scene.geometry->line.pieces() == 0) return true;
  const Eigen::Vector3d extent = scene.geometry->box.high - scene.geometry->box.low;
  return screen.x.cwiseAbs().dot(extent) < 2 && screen.y.cwiseAbs().dot(extent) < 2;
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
  const StrokeOptions options{style.by, style.colours != nullptr, style.detail, style.cut, style.most_cuts};
  const StrokeMaker maker(scene, projection, QRectF(image.rect()).adjusted(-4, -4, 4, 4), options);
  return maker.make([&](const Stroke& s) {
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
  const StrokeOptions options{style.by, style.colours != nullptr, style.detail, style.cut, style.most_cuts};
  const StrokeMaker maker(scene, projection, QRectF({0, 0}, size).adjusted(-4, -4, 4, 4), options);
  maker.make([&](const Stroke& s) {
    const QRgb colour = s.rapid ? style.rapid : style.colours && s.shade ? (*style.colours)[*s.shade] : style.plain;
    painter.setPen(QPen(QColor(colour), s.rapid ? style.width / 2 : style.width, s.rapid ? Qt::DashLine : Qt::SolidLine,
                        Qt::RoundCap));
    painter.drawLine(s.from, s.to);
  });
}

std::vector<DirectionMark> direction_marks(const ContourScene& scene, const Projection& projection, const QSizeF& size,
                                           double apart, std::size_t most) {
  constexpr std::size_t kMostPieces = 20'000;
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
  const double step = std::max(apart, sum / static_cast<double>(most));
  double left = step / 2;
  visit([&](const QPointF& from, const QPointF& way, double begin, double end) {
    for (begin += left; begin < end; begin += step) marks.push_back({from + begin * way, way});
    left = begin - end;
  });
  return marks;
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
  if (scene.is_empty()) return 0;
  return StrokeMaker(scene, projection, QRectF(QPointF(0, 0), size), {}).visible();
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

std::optional<Pick> pick(const ContourScene& scene, const Projection& projection, const QPointF& at, double radius) {
  const Screen screen(projection, scene.geometry->centre);
  const auto& vertex = scene.geometry->line.vertex;
  const QRectF near(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
  std::optional<Pick> best;
  for (const auto& [first, last] : runs_near(scene, projection, near)) {
    QPointF from = screen.map(vertex[first]);
    for (std::size_t i = first; i < last; ++i) {
      const QPointF to = screen.map(vertex[i + 1]);
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
