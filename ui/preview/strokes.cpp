#include "preview/strokes.h"

#include "toolpace/path/path.h"

namespace toolpace::ui {

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

StrokeMaker::StrokeMaker(const ContourScene& scene, const Projection& projection, const QRectF& window,
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
  pixels_ = measure();
  if (pixels_ > options.most_pixels) kept_ = options.most_pixels / pixels_;
  step_ = step();
}

std::size_t StrokeMaker::visible() const { return std::min(chunks_.size() * kChunk, pieces()); }

// Of many chunks some stand for all.
double StrokeMaker::measure() const {
  constexpr std::size_t kMeasured = 256;  // chunks
  const std::size_t stride = std::max<std::size_t>(chunks_.size() / kMeasured, 1);
  double sum = 0;
  for_each_piece(
      [&](std::size_t, const QPointF& from, const QPointF& to) {
        const auto [begin, end] = inside(from, to, window_);
        if (end > begin) sum += (end - begin) * std::hypot(to.x() - from.x(), to.y() - from.y());
      },
      stride);
  return sum * static_cast<double>(stride);
}

double StrokeMaker::step() const {
  if (!shades_ || options_.most_cuts == 0 || chunks_.size() * kChunk > 2 * options_.most_cuts) return 0;
  return std::max(options_.cut, pixels_ / static_cast<double>(options_.most_cuts));
}

QPointF StrokeMaker::place(std::size_t piece, const Stroke& whole, double share) const {
  const std::size_t block = geometry_.block_of(piece);
  const Path& path = *scene_.outcome->path;
  if (path.kind[block] == SegmentKind::line || !geometry_.time.empty() || share <= 0 || share >= 1) {
    return whole.from + share * (whole.to - whole.from);
  }
  const double before = geometry_.share_before(piece), after = geometry_.share_after(piece);
  const double along = path.length[block] * (before + (after - before) * share);
  return screen_.map((point_at(path, block, along).head<3>() - geometry_.centre).cast<float>());
}

}  // namespace toolpace::ui
