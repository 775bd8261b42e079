/// What lies over and under the path in the contour preview.

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "drawing/cause_style.h"
#include "preview/contour_canvas.h"
#include "toolpace/plan/plan.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kMostBandPieces = 20'000;
constexpr double kMostOfScaleBar = 110, kAxesWidth = 76, kScaleBarWidth = kMostOfScaleBar + 24;  // px, of the foot

QColor faded(const QColor& colour, double alpha) {
  QColor c = colour;
  c.setAlphaF(static_cast<float>(alpha));
  return c;
}

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= most) return step * power;
  }
  return power;
}

void draw_chip(QPainter& painter, const Theme& theme, const QRectF& area, const QStringList& lines) {
  painter.setPen(QPen(theme.line, 1));
  painter.setBrush(faded(theme.surface, 0.94));
  painter.drawRoundedRect(area, 4, 4);
  const double step = (area.height() - 8) / static_cast<double>(lines.size());
  for (int i = 0; i < lines.size(); ++i) {
    painter.setPen(i == 0 ? theme.text : theme.secondary);
    painter.drawText(QRectF(area.left() + 8, area.top() + 4 + i * step, area.width() - 16, step),
                     Qt::AlignVCenter | Qt::AlignLeft, lines[i]);
  }
}

}  // namespace

void ContourCanvas::drawTravel(QPainter& painter, const Projection& projection) const {
  if (!scene_->travel) return;
  const Box& box = *scene_->travel;
  const auto corner = [&](int bits) {
    return projection.map({bits & 1 ? box.high.x() : box.low.x(), bits & 2 ? box.high.y() : box.low.y(),
                           bits & 4 ? box.high.z() : box.low.z()});
  };
  const bool outside = (scene_->geometry->box.low.array() < box.low.array() - 1e-9).any() ||
                       (scene_->geometry->box.high.array() > box.high.array() + 1e-9).any();
  painter.setPen(QPen(outside ? theme_.error : theme_.line, 1.2));
  for (int from = 0; from < 8; ++from) {
    for (int bit = 1; bit < 8; bit *= 2) {
      if (!(from & bit)) painter.drawLine(corner(from), corner(from | bit));
    }
  }
}

void ContourCanvas::drawBand(QPainter& painter, const Projection& projection) const {
  const double wide = 2 * tolerance_ * projection.scale;
  const QRectF window = QRectF(painter.viewport()).adjusted(-wide, -wide, wide, wide);
  if (wide < 3 || !std::isfinite(wide)) return;
  const auto runs = runs_near(*scene_, projection, window);
  if (runs.size() * kChunk > kMostBandPieces) return;
  QPainterPath path;
  for (const auto& [first, last] : runs) {
    path.moveTo(projection.map(scene_->point(first)));
    for (std::size_t i = first + 1; i <= last; ++i) path.lineTo(projection.map(scene_->point(i)));
  }
  QPen pen(theme_.accent, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  QColor tint = theme_.accent;
  const auto blend = [&](int a, int b) { return a + (b - a) * 14 / 100; };
  tint.setRgb(blend(theme_.surface.red(), tint.red()), blend(theme_.surface.green(), tint.green()),
              blend(theme_.surface.blue(), tint.blue()));
  pen.setColor(tint);
  painter.strokePath(path, pen);
}

/// Where the path begins (ring) and ends (square), and the way along it.
void ContourCanvas::drawDirection(QPainter& painter, const Projection& projection, const QSizeF& size,
                                  double ratio) const {
  if (scene_->is_empty() || scene_->geometry->line.pieces() == 0) return;
  constexpr double kApart = 150, kArm = 4.5;
  constexpr std::size_t kMost = 40;
  QPainterPath chevrons;
  for (const auto& mark : direction_marks(*scene_, projection, size, kApart * ratio, kMost)) {
    const QPointF back = -kArm * ratio * mark.way, side(back.y(), -back.x());
    chevrons.moveTo(mark.at + back + side);
    chevrons.lineTo(mark.at - 0.2 * back);
    chevrons.lineTo(mark.at + back - side);
  }
  painter.setBrush(Qt::NoBrush);
  painter.strokePath(chevrons, QPen(theme_.surface, 4 * ratio, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.strokePath(chevrons, QPen(theme_.text, 1.4 * ratio, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF begin = projection.map(scene_->point(0));
  const QPointF end = projection.map(scene_->point(scene_->geometry->line.vertex.size() - 1));
  const double r = 3.5 * ratio;
  painter.setPen(QPen(theme_.surface, 1 * ratio));
  painter.setBrush(theme_.text);
  painter.drawRect(QRectF(end - QPointF(r, r), QSizeF(2 * r, 2 * r)));
  painter.setPen(QPen(theme_.text, 1.6 * ratio));
  painter.setBrush(theme_.surface);
  // On a closed path the ring stands around the square.
  const bool closed = QLineF(begin, end).length() < 2 * r;
  if (closed) painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(begin, closed ? 1.8 * r : 1.2 * r, closed ? 1.8 * r : 1.2 * r);
}

void ContourCanvas::drawHighlight(QPainter& painter) const {
  if (!highlight_ || !scene_->colours) return;
  const auto& geometry = *scene_->geometry;
  // Vertices of the blocks that the span covers.
  const auto vertex_of = [&](std::size_t block) {
    if (geometry.block.empty()) return block;
    return static_cast<std::size_t>(std::lower_bound(geometry.block.begin(), geometry.block.end(), block) -
                                    geometry.block.begin());
  };
  const double hair = 1e-9 * (1 + highlight_->second);
  const std::size_t from = vertex_of(segment_at(scene_->outcome->node_time, highlight_->first + hair));
  const std::size_t to = vertex_of(segment_at(scene_->outcome->node_time, highlight_->second - hair) + 1);
  if (to <= from || to >= geometry.line.vertex.size()) return;
  QPainterPath path;
  const std::size_t stride = std::max<std::size_t>((to - from) / kMostBandPieces, 1);
  path.moveTo(projection_.map(scene_->point(from)));
  for (std::size_t i = from + 1; i < to; i += stride) path.lineTo(projection_.map(scene_->point(i)));
  path.lineTo(projection_.map(scene_->point(to)));
  painter.strokePath(path, QPen(faded(theme_.accent, 0.30), 6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

void ContourCanvas::drawCursor(QPainter& painter) const {
  if (!cursor_) return;
  const QPointF at = projection_.map(cursor_->position.head<3>());
  painter.setPen(QPen(theme_.surface, 4));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(at, 7, 7);
  painter.setPen(QPen(theme_.accent, 2));
  painter.drawEllipse(at, 7, 7);
  painter.setBrush(theme_.accent);
  painter.drawEllipse(at, 1.5, 1.5);
}

void ContourCanvas::drawAxes(QPainter& painter) const {
  const QPointF origin(34, height() - 34);
  const struct {
    Eigen::Vector3d direction;
    QColor colour;
    const char* name;
    Qt::PenStyle dash;
  } axes[] = {{Eigen::Vector3d::UnitX(), theme_.axis_x, "X", Qt::SolidLine},
              {Eigen::Vector3d::UnitY(), theme_.axis_y, "Y", Qt::DashLine},
              {Eigen::Vector3d::UnitZ(), theme_.axis_z, "Z", Qt::DotLine}};
  for (const auto& axis : axes) {
    const QPointF tip(24 * projection_.right.dot(axis.direction), -24 * projection_.up.dot(axis.direction));
    const double length = std::hypot(tip.x(), tip.y());
    painter.setPen(QPen(axis.colour, 1.6, axis.dash, Qt::RoundCap));
    if (length < 2) {
      painter.setBrush(axis.colour);
      painter.drawEllipse(origin, 2, 2);
      continue;
    }
    painter.drawLine(origin, origin + tip);
    const QPointF label = origin + tip * (1 + 9 / length);
    painter.drawText(QRectF(label.x() - 8, label.y() - 8, 16, 16), Qt::AlignCenter, axis.name);
  }
}

void ContourCanvas::drawScaleBar(QPainter& painter) const {
  const DisplayUnit unit = display_unit(Quantity::length, unit_);
  const double most = kMostOfScaleBar / projection_.scale * unit.factor;
  if (!std::isfinite(most) || most <= 0) return;
  const double shown = round_length(most), pixels = shown / unit.factor * projection_.scale;
  const QPointF right(width() - 16, height() - 16), left = right - QPointF(pixels, 0);
  painter.setPen(QPen(theme_.secondary, 1.2));
  painter.drawLine(left, right);
  painter.drawLine(left - QPointF(0, 4), left);
  painter.drawLine(right - QPointF(0, 4), right);
  painter.drawText(QRectF(right.x() - 160, right.y() - 24, 160, 18), Qt::AlignRight | Qt::AlignBottom,
                   number_text(shown, 3) + " " + unit.text);
}

void ContourCanvas::drawHover(QPainter& painter) const {
  if (!hovered_ || dragging_) return;
  const QPointF at = projection_.map(hovered_->position.head<3>());
  painter.setPen(QPen(theme_.text, 1.5));
  painter.setBrush(theme_.surface);
  painter.drawEllipse(at, 3.5, 3.5);

  const auto value = [this](double core, Quantity quantity) { return value_text(core, quantity, unit_, 4); };
  QStringList lines;
  QString head;
  if (hovered_->line > 0) head = tr("line %1").arg(hovered_->line) + "   ";
  lines << head + value(hovered_->state.speed, Quantity::speed);
  const auto coordinate = [this](double mm) {
    return QString::number(mm * display_unit(Quantity::length, unit_).factor, 'f',
                           decimals_of(Quantity::length, 3, unit_));
  };
  lines << QString("X %1  Y %2  Z %3")
               .arg(coordinate(hovered_->position.x()), coordinate(hovered_->position.y()),
                    coordinate(hovered_->position.z()));
  lines << "a " + value(hovered_->state.acceleration, Quantity::acceleration) + "   j " +
               value(hovered_->state.jerk, Quantity::jerk);
  if (hovered_->cause) lines << tr("held by: %1").arg(cause_title(*hovered_->cause));
  if (const auto row = tube_ ? tube_->row_at(hovered_->time) : std::nullopt) {
    if (const QString text = tube_text(*tube_, *row, unit_); !text.isEmpty()) lines << text;
  }
  const QFontMetricsF metrics(font());
  double wide = 0;
  for (const auto& line : lines) wide = std::max(wide, metrics.horizontalAdvance(line));
  QRectF area(hover_at_.x() + 16, hover_at_.y() + 16, wide + 18,
              metrics.height() * static_cast<double>(lines.size()) + 12);
  if (area.right() > width() - 4) area.moveRight(hover_at_.x() - 12);
  if (area.bottom() > height() - 4) area.moveBottom(hover_at_.y() - 12);
  area.moveLeft(std::max(area.left(), 4.0));
  draw_chip(painter, theme_, area, lines);
}

/// What is enlarged, and how much of the tolerance the plan takes.
void ContourCanvas::drawCaption(QPainter& painter) const {
  QStringList texts;
  if (enlargement_ > 1) texts << QStringLiteral("×%1").arg(enlargement_);
  if (tube_ && band_shown_ && tube_->size() > 0) texts << tube_caption(*tube_, unit_);
  if (texts.isEmpty()) return;
  const QString text = texts.join(QStringLiteral("  ·  "));
  const QSizeF words = QFontMetricsF(painter.font()).size(Qt::TextSingleLine, text);
  // At the foot, which Fit keeps free, between the axes and the scale bar; above the path where that is too narrow.
  QRectF area({kAxesWidth, 4}, QSizeF(words.width() + 18, words.height() + 8));
  if (area.right() < width() - kScaleBarWidth) {
    area.moveBottom(height() - 2);
  } else {
    area.moveLeft(8);
  }
  draw_chip(painter, theme_, area, {text});
}

void ContourCanvas::drawHint(QPainter& painter) const {
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.25);
  painter.setFont(large);
  painter.setPen(theme_.secondary);
  const QRectF area = QRectF(rect()).adjusted(24, 24, -24, -24);
  painter.drawText(area, static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, tr("drop an NC program here"));
}

void ContourCanvas::paintVectors(QPainter& painter, const QSizeF& size) const {
  painter.fillRect(QRectF({0, 0}, size), theme_.surface);
  if (!scene_ || scene_->is_empty()) return;
  Projection p = projection_;
  const double ratio = std::min(size.width() / std::max(width(), 1), size.height() / std::max(height(), 1));
  p.origin = QPointF(size.width() / 2, size.height() / 2) + (p.origin - QPointF(width() / 2.0, height() / 2.0)) * ratio;
  p.scale *= ratio;
  painter.setClipRect(QRectF({0, 0}, size));
  drawTravel(painter, p);
  if (tolerance_ > 0 && band_shown_ && !tube_) drawBand(painter, p);
  const bool in_band = tube_ && band_shown_;
  const TubeStyle tube_style{theme_, enlargement_, 1.4};
  const bool has_band = in_band && paint_band(painter, QRectF({0, 0}, size), *tube_, p, tube_style);
  if (ghost_) {
    SceneStyle ghost;
    ghost.plain = ghost.rapid = theme_.plan_b.rgb();
    ghost.all_dashed = true;
    ghost.rapids = rapids_shown_;
    ghost.width = 1.2;
    ghost.detail = 0.4;
    paint_scene(painter, *ghost_, p, size, ghost);
  }
  SceneStyle style;
  style.by = by_;
  style.colours = scene_->can_colour_by(by_) ? &colours_ : nullptr;
  style.plain = theme_.accent.rgb();
  style.rapid = theme_.secondary.rgb();
  style.rapids = rapids_shown_;
  style.width = 1.2;
  style.detail = 0.4;
  paint_scene(painter, *scene_, p, size, style);
  if (has_band) paint_inside_band(painter, *tube_, p, tube_style);
  if (showsTrace()) paint_trace(painter, *scene_->trace, p, enlargement_, theme_.error.rgb(), 1.0);
  if (showsMeasured()) paint_trace(painter, *measured_, p, enlargement_, theme_.text.rgb(), 1.0);
  drawDirection(painter, p, size, 1.0);
}

}  // namespace toolpace::ui
