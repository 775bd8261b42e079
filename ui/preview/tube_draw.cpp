#include "preview/tube_draw.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "preview/raster.h"
#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastBand = 1.5;               // px on each side; a narrower one says nothing
constexpr double kStep = 0.8;                    // px; shorter pieces are joined
constexpr std::size_t kMostBandPieces = 30'000;  // stroking is slow
constexpr double kBandShare = 0.16, kEdgeShare = 0.4;

/// A row on the screen: on the programmed path, and inside the enlarged band.
struct Place {
  QPointF programmed, planned;
  double half_band;  ///< [px]
};

class TubeScreen {
 public:
  TubeScreen(const TubeTrace& trace, const Projection& projection, double enlargement)
      : trace_(trace), projection_(projection), enlargement_(enlargement) {}

  Place at(std::size_t row) const {
    const Eigen::Vector3d foot = trace_.programmed[row].cast<double>();
    const Eigen::Vector3d offset = enlargement_ * trace_.offset[row].cast<double>();
    return {projection_.map(foot), projection_.map(foot + offset),
            enlargement_ * trace_.tolerance[row] * projection_.scale};
  }

 private:
  const TubeTrace& trace_;
  const Projection& projection_;
  double enlargement_;
};

double span(const QPointF& from, const QPointF& to) {
  return std::abs(to.x() - from.x()) + std::abs(to.y() - from.y());
}

/// The programmed path in stretches of one tolerance, as far as they are in the window.
struct Band {
  QPainterPath path;
  double half_width;
};

std::vector<Band> bands_in(const TubeTrace& trace, const TubeScreen& screen, const QRectF& window,
                           std::size_t& pieces) {
  std::vector<Band> bands;
  bool inside = false;
  float tolerance = -1;
  QPointF last;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const Place place = screen.at(i);
    const double margin = place.half_band + 2;
    const bool visible = window.adjusted(-margin, -margin, margin, margin).contains(place.programmed);
    if (visible && (!inside || trace.tolerance[i] != tolerance)) {
      tolerance = trace.tolerance[i];
      if (bands.empty() || bands.back().half_width != place.half_band) bands.push_back({{}, place.half_band});
      bands.back().path.moveTo(inside ? last : place.programmed);
      last = place.programmed;
    }
    if (inside && (span(last, place.programmed) >= kStep || i + 1 == trace.size() || !visible)) {
      bands.back().path.lineTo(place.programmed);
      last = place.programmed;
      ++pieces;
    }
    inside = visible;
  }
  return bands;
}

void stroke(QPainter& painter, const std::vector<Band>& bands, const TubeStyle& style) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor edge = mixed(style.theme.surface, style.theme.accent, kEdgeShare);
  const QColor fill = mixed(style.theme.surface, style.theme.accent, kBandShare);
  for (const bool edges : {true, false}) {
    for (const Band& band : bands) {
      if (band.half_width < kLeastBand) continue;
      const double width = 2 * band.half_width + (edges ? 1.0 : -1.0);
      painter.strokePath(band.path, QPen(edges ? edge : fill, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
  }
  for (const Band& band : bands) {
    painter.strokePath(band.path, QPen(style.theme.secondary, 1, Qt::DashLine));
  }
}

/// Gives `line` (from, to, colour) the pieces of the planned path, joined where they are shorter than a pixel.
template <class Line>
void follow_planned(const TubeTrace& trace, const TubeScreen& screen, const TubeStyle& style, const Line& line) {
  QPointF from = screen.at(0).planned;
  double share = 0;  // the largest since the last piece
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const QPointF to = screen.at(i).planned;
    share = std::max(share, trace.share(i));
    if (i + 1 < trace.size() && span(from, to) < kStep) continue;
    line(from, to, share >= kUsedUp ? style.theme.warning : style.theme.accent);
    from = to;
    share = 0;
  }
}

}  // namespace

bool paint_band(QPainter& painter, const QRectF& window, const TubeTrace& trace, const Projection& projection,
                const TubeStyle& style) {
  if (trace.size() < 2) return false;
  const double widest = *std::max_element(trace.tolerance.begin(), trace.tolerance.end());
  if (style.enlargement * widest * projection.scale < kLeastBand) return false;
  std::size_t pieces = 0;
  const auto bands = bands_in(trace, TubeScreen(trace, projection, style.enlargement), window, pieces);
  if (pieces > kMostBandPieces) return false;
  stroke(painter, bands, style);
  return true;
}

bool draw_band(QImage& image, const TubeTrace& trace, const Projection& projection, const TubeStyle& style) {
  QPainter painter(&image);
  return paint_band(painter, QRectF(image.rect()), trace, projection, style);
}

namespace {

/// A ring at the place that uses most of the tolerance.
void paint_worst(QPainter& painter, const TubeTrace& trace, const TubeScreen& screen, const TubeStyle& style) {
  if (trace.largest_share <= 0) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const double radius = 4 * style.width;
  painter.setPen(QPen(trace.largest_share >= kUsedUp ? style.theme.warning : style.theme.accent, style.width));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(screen.at(trace.worst).planned, radius, radius);
}

}  // namespace

void draw_inside_band(QImage& image, const TubeTrace& trace, const Projection& projection, const TubeStyle& style) {
  if (trace.size() < 2) return;
  const TubeScreen screen(trace, projection, style.enlargement);
  if (style.enlargement > 1) {
    LineRaster lines(image, style.width, true);
    follow_planned(trace, screen, style, [&](const QPointF& from, const QPointF& to, const QColor& colour) {
      lines.draw(from.x(), from.y(), to.x(), to.y(), colour.rgb());
    });
  }
  QPainter painter(&image);
  paint_worst(painter, trace, screen, style);
}

void paint_inside_band(QPainter& painter, const TubeTrace& trace, const Projection& projection,
                       const TubeStyle& style) {
  if (trace.size() < 2) return;
  const TubeScreen screen(trace, projection, style.enlargement);
  if (style.enlargement > 1) {
    follow_planned(trace, screen, style, [&](const QPointF& from, const QPointF& to, const QColor& colour) {
      painter.setPen(QPen(colour, style.width, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(from, to);
    });
  }
  paint_worst(painter, trace, screen, style);
}

QString tube_caption(const TubeTrace& trace, Units unit) {
  const DisplayUnit shown = error_unit(unit);
  const double tolerance = trace.size() > 0 ? static_cast<double>(trace.tolerance[trace.worst]) : 0.0;
  return QCoreApplication::translate("Tube", "band ±%1 %2, used up to %3 %")
      .arg(number_text(tolerance * shown.factor, 3), shown.text, QString::number(trace.largest_share * 100, 'f', 0));
}

QString tube_text(const TubeTrace& trace, std::size_t row, Units unit) {
  if (row >= trace.size() || trace.tolerance[row] <= 0) return {};
  const DisplayUnit shown = error_unit(unit);
  return QCoreApplication::translate("Tube", "%1 of %2 %3 tolerance (%4 %)")
      .arg(number_text(static_cast<double>(trace.offset[row].norm()) * shown.factor, 3),
           number_text(static_cast<double>(trace.tolerance[row]) * shown.factor, 3), shown.text,
           QString::number(trace.share(row) * 100, 'f', 0));
}

}  // namespace toolpace::ui
