#pragma once
/// What can be seen of a scene, as straight strokes of one colour each.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "drawing/contour_scene.h"
#include "preview/screen.h"

namespace toolpace::ui {

struct StrokeOptions {
  ColourBy by = ColourBy::speed;
  bool coloured = false;
  double detail = 0.75;        ///< largest distance between drawn and true line [px]
  double cut = 4;              ///< long pieces are cut this short [px]
  std::size_t most_cuts = 0;   ///< in one picture; more make longer ones. 0 = none
  double most_pixels = 1e300;  ///< beyond so many pixels of strokes, a random part of the pieces stands for all
};

/// A piece of the path on the screen, in one colour.
struct Stroke {
  QPointF from, to;
  std::optional<std::uint8_t> shade;  ///< nothing: no colour is known
  bool rapid;
};

/// What a picture takes.
struct DrawingLoad {
  std::size_t pieces = 0;
  double pixels = 0;  ///< length of all strokes inside the window, roughly [px]
};

/// Cuts what can be seen of a scene into strokes. Pieces that are long on the screen are cut where they are seen, so that
/// colours follow the plan, and lines the curve, at any enlargement.
class StrokeMaker {
 public:
  /// The scene must have a geometry that is not empty, and outlive the maker.
  StrokeMaker(const ContourScene& scene, const Projection& projection, const QRectF& window,
              const StrokeOptions& options);

  std::size_t visible() const;  ///< pieces in chunks that the window meets
  DrawingLoad load() const { return {visible(), pixels_}; }

  /// Calls take(const Stroke&) for each; returns the number of pieces drawn.
  template <class Take>
  std::size_t make(const Take& take) const {
    std::size_t drawn = 0;
    for_each_piece([&](std::size_t j, const QPointF& from, const QPointF& to) {
      if (is_left_out(j)) return;
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
  std::size_t pieces() const { return level_.is_full() ? geometry_.line.pieces() : level_.vertex.size() - 1; }
  double measure() const;
  double step() const;
  /// By chance, so that no pattern of the program meets one of ours.
  bool is_left_out(std::size_t piece) const {
    return kept_ < 1 && static_cast<std::uint32_t>(piece) * 2654435761u > kept_ * 4294967295.0;
  }

  template <class Visit>
  void for_each_piece(const Visit& visit, std::size_t stride = 1) const {
    const std::size_t count = pieces();
    for (std::size_t n = 0; n < chunks_.size(); n += stride) {
      const std::size_t first = chunks_[n] * kChunk, last = std::min(first + kChunk, count);
      QPointF from = screen_.map(geometry_.line.vertex[level_.at(first)]);
      for (std::size_t j = first; j < last; ++j) {
        const QPointF to = screen_.map(geometry_.line.vertex[level_.at(j + 1)]);
        visit(j, from, to);
        from = to;
      }
    }
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
  QPointF place(std::size_t piece, const Stroke& whole, double share) const;

  const ContourScene& scene_;
  const SceneGeometry& geometry_;
  StrokeOptions options_;
  QRectF window_;
  Screen screen_;
  std::size_t index_;
  const LodLevel& level_;
  const std::vector<std::uint8_t>* shades_ = nullptr;
  std::vector<std::size_t> chunks_;
  double pixels_ = 0;
  double kept_ = 1;  // of the pieces
  double step_ = 0;  // length of a cut [px], 0 = nothing is cut
};

}  // namespace toolpace::ui
