#include "panels/polar_plot.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "toolpace/base/axes.h"

namespace toolpace::ui {
namespace {

constexpr double kCircleShare = 0.62, kErrorShare = 0.26;  // of half the height
constexpr double kStep = 0.7;                              // px between points of the curve
constexpr double kPick = 16;                               // px
constexpr double kRim = 4;                                 // px
constexpr double kLeastError = 1e-9;                       // [mm]; nothing to enlarge

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_step(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
}

}  // namespace

PolarPlot::PolarPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("polarPlot");
  setFocusPolicy(Qt::StrongFocus);
}

void PolarPlot::setRoundness(std::shared_ptr<const Roundness> roundness) {
  roundness_ = std::move(roundness);
  update();
}

void PolarPlot::setEnlargement(std::optional<double> factor) {
  factor_ = factor;
  update();
}

void PolarPlot::setCursorTime(std::optional<double> time) {
  cursor_ = time;
  update();
}

void PolarPlot::setUnit(Units unit) {
  unit_ = unit;
  update();
}

void PolarPlot::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void PolarPlot::setEmptyHint(const QString& text) {
  empty_hint_ = text;
  update();
}

double PolarPlot::circleRadius() const { return kCircleShare * std::min(width(), height()) / 2; }

double PolarPlot::pixelsPerMm() const {
  const double natural = circleRadius() / std::max(roundness_->circle.start_radius, 1e-12);
  if (factor_) return natural * *factor_;
  const double most = std::max(std::abs(roundness_->most()), std::abs(roundness_->least()));
  if (most < kLeastError) return natural;
  const double factor = kErrorShare / kCircleShare * circleRadius() / most / natural;
  return natural * (factor > 1 ? round_step(factor) : factor);
}

double PolarPlot::enlargement() const {
  if (!roundness_ || roundness_->is_empty()) return 1;
  return pixelsPerMm() / (circleRadius() / std::max(roundness_->circle.start_radius, 1e-12));
}

QPointF PolarPlot::position(const Roundness::Point& point) const {
  const double edge = std::min(width(), height()) / 2.0 - kRim;
  const double radius = std::clamp(circleRadius() + point.error * pixelsPerMm(), 0.0, edge);
  return QPointF(width() / 2.0, height() / 2.0) +
         QPointF(radius * std::cos(point.angle), -radius * std::sin(point.angle));
}

void PolarPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.surface);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!roundness_ || roundness_->is_empty()) {
    painter.setPen(theme_.secondary);
    painter.drawText(rect().adjusted(16, 8, -16, -8), static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap,
                     empty_hint_);
    return;
  }
  drawRings(painter);
  drawCurve(painter);
  drawMarks(painter);
}

void PolarPlot::drawRings(QPainter& painter) const {
  const QPointF middle(width() / 2.0, height() / 2.0);
  const double radius = circleRadius(), edge = std::min(width(), height()) / 2.0 - kRim;
  painter.setPen(QPen(theme_.line, 1));
  painter.drawLine(middle - QPointF(edge, 0), middle + QPointF(edge, 0));
  painter.drawLine(middle - QPointF(0, edge), middle + QPointF(0, edge));
  const double micron = unit_.inch ? 1e3 * display_unit(Quantity::length, unit_).factor : 1e3;
  const double step = round_step((edge - radius) * 0.75 / pixelsPerMm() * micron) / micron;
  for (const double error : {-step, step}) {
    const double ring = radius + error * pixelsPerMm();
    if (ring <= 4) continue;
    painter.setPen(QPen(theme_.line, 1));
    painter.drawEllipse(middle, ring, ring);
    painter.setPen(theme_.secondary);
    const QString text = (error > 0 ? "+" : "−") + number_text(step * micron, 3) +
                         (unit_.inch ? QStringLiteral(" mil") : QStringLiteral(" µm"));
    painter.drawText(QRectF(middle.x() + 4, middle.y() - ring - 8, 80, 16), Qt::AlignLeft | Qt::AlignVCenter, text);
  }
  painter.setPen(QPen(theme_.secondary, 1, Qt::DashLine));
  painter.drawEllipse(middle, radius, radius);
  const auto name = [this](int i) {
    return QString(
        QLatin1Char(kAxisNames[static_cast<std::size_t>(roundness_->circle.axes[static_cast<std::size_t>(i)])]));
  };
  painter.setPen(theme_.secondary);
  painter.drawText(QRectF(middle.x() + edge - 16, middle.y() - 18, 16, 16), Qt::AlignCenter, name(0));
  painter.drawText(QRectF(middle.x() - 18, middle.y() - edge, 16, 16), Qt::AlignCenter, name(1));
}

/// Run-in and run-out faintly: they are not judged.
void PolarPlot::drawCurve(QPainter& painter) const {
  const Roundness& r = *roundness_;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_.secondary, 1, Qt::DotLine));
  painter.drawPath(curve(0, r.first));
  painter.drawPath(curve(r.last - 1, r.points.size() - 1));
  painter.setPen(QPen(theme_.accent, 1.6));
  painter.drawPath(curve(r.first, r.last - 1));
}

QPainterPath PolarPlot::curve(std::size_t from, std::size_t to) const {
  QPointF last = position(roundness_->points[from]);
  QPainterPath path(last);
  for (std::size_t i = from + 1; i <= to; ++i) {
    const QPointF at = position(roundness_->points[i]);
    if ((at - last).manhattanLength() < kStep && i < to) continue;
    path.lineTo(at);
    last = at;
  }
  return path;
}

void PolarPlot::drawMarks(QPainter& painter) const {
  const auto mark = [&](std::size_t index, const QColor& colour) {
    painter.setPen(QPen(colour, 2));
    painter.setBrush(theme_.surface);
    painter.drawEllipse(position(roundness_->points[index]), 4, 4);
  };
  mark(roundness_->highest, theme_.error);
  mark(roundness_->lowest, theme_.axis_z);
  if (!cursor_ || *cursor_ < roundness_->points.front().time || *cursor_ > roundness_->points.back().time) return;
  const auto after = std::lower_bound(roundness_->points.begin(), roundness_->points.end(), *cursor_,
                                      [](const Roundness::Point& p, double t) { return p.time < t; });
  painter.setPen(QPen(theme_.accent, 1));
  painter.setBrush(theme_.accent);
  painter.drawEllipse(position(*after), 3, 3);
}

void PolarPlot::mousePressEvent(QMouseEvent* event) {
  if (!roundness_ || event->button() != Qt::LeftButton) return;
  const Roundness::Point* best = nullptr;
  double least = kPick;
  for (const auto& point : roundness_->points) {
    const QPointF gap = position(point) - event->position();
    const double distance = std::hypot(gap.x(), gap.y());
    if (distance < least) (least = distance, best = &point);
  }
  if (best) emit timeClicked(best->time);
}

}  // namespace toolpace::ui
