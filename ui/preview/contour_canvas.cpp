#include "preview/contour_canvas.h"

#include <QPainter>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "drawing/cause_style.h"

namespace toolpace::ui {
namespace {

constexpr int kSettleMs = 140;
constexpr qint64 kDragMs = 500, kLongestSettleMs = 600;
// What a picture may take to be drawn smooth, and quickly.
constexpr DrawingLoad kSmoothWhileMoving = {40'000, 0.5e6}, kSmoothAtRest = {600'000, 4e6};
constexpr double kPixelsWhileMoving = 4e6, kPixelsAtRest = 40e6;
constexpr double kCovered = 6;                          // times the picture: more lines would not be told apart
constexpr double kFitMargin = 28, kMostMargin = 0.1;    // px; of the smaller side
constexpr int kFootHeight = 24;                         // px
constexpr double kLeastScale = 1e-7, kMostScale = 1e9;  // px/mm

}  // namespace

ContourCanvas::ContourCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName("contourCanvas");
  setAccessibleName(tr("Contour preview"));
  setMouseTracking(true);
  setContextMenuPolicy(
      Qt::PreventContextMenu);  // its button turns the picture; menuRequested() is for when it does not
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  settle_.setSingleShot(true);
  connect(&settle_, &QTimer::timeout, this, [this] {
    moving_ = false;
    redraw();
  });
  projection_ = named_view(View::xy);
  updateColours();
}

void ContourCanvas::setScene(std::shared_ptr<const ContourScene> scene) {
  const bool was_empty = !scene_ || scene_->is_empty();
  // Plans that follow each other quickly are a drag: it is drawn quickly, too, and smoothly when no other one comes.
  // The same plan with its contour errors is none.
  const bool another_plan = !was_empty && scene && scene->outcome != scene_->outcome;
  const qint64 interval = since_scene_.isValid() ? since_scene_.elapsed() : kDragMs;
  if (another_plan && interval < kDragMs) {
    moving_ = true;
    settle_.start(static_cast<int>(std::clamp<qint64>(2 * interval, kSettleMs, kLongestSettleMs)));
  }
  since_scene_.start();
  scene_ = std::move(scene);
  hovered_.reset();
  setCursorTime(cursor_time_);
  if (was_empty || follows_fit_) fit();
  redraw();
}

void ContourCanvas::setGhost(std::shared_ptr<const ContourScene> scene) {
  ghost_ = std::move(scene);
  follows_fit_ ? fit() : redraw();
}

void ContourCanvas::setTheme(const Theme& theme) {
  theme_ = theme;
  updateColours();
}

void ContourCanvas::setUnit(Units unit) {
  unit_ = unit;
  update();
}

void ContourCanvas::setColourBy(ColourBy by) {
  by_ = by;
  updateColours();
}

void ContourCanvas::setColourMap(ColourMap map) {
  map_ = map;
  updateColours();
}

void ContourCanvas::updateColours() {
  const Ground ground = theme_.dark ? Ground::dark : Ground::light;
  if (by_ == ColourBy::limit) {
    colours_.fill(theme_.secondary.rgb());
    for (std::size_t i = 0; i < kCauseCount; ++i) colours_[i] = cause_colour(static_cast<Cause>(i), ground).rgb();
  } else {
    colours_ = is_signed(by_) ? diverging_table(ground) : colour_table(map_, ground);
  }
  redraw();
}

void ContourCanvas::setMeasured(std::shared_ptr<const ErrorTrace> measured) {
  if (measured == measured_) return;
  measured_ = std::move(measured);
  redraw();
}

void ContourCanvas::setEnlargement(double factor) {
  enlargement_ = std::max(factor, 1.0);
  redraw();
}

void ContourCanvas::setTolerance(double tolerance) {
  tolerance_ = std::max(tolerance, 0.0);
  redraw();
}

void ContourCanvas::setTube(std::shared_ptr<const TubeTrace> tube) {
  tube_ = std::move(tube);
  redraw();
}

void ContourCanvas::setBandShown(bool shown) {
  band_shown_ = shown;
  redraw();
}

void ContourCanvas::setRapidsShown(bool shown) {
  if (rapids_shown_ == shown) return;
  rapids_shown_ = shown;
  follows_fit_ ? fit() : redraw();
}

void ContourCanvas::setCursorTime(std::optional<double> time) {
  cursor_time_ = time;
  cursor_.reset();
  if (time && scene_ && scene_->outcome) cursor_ = instant_at(*scene_->outcome, *time);
  update();
}

void ContourCanvas::setHighlight(std::optional<std::pair<double, double>> span) {
  highlight_ = span;
  update();
}

void ContourCanvas::setView(View view) {
  const Projection named = named_view(view);
  projection_.right = named.right;
  projection_.up = named.up;
  emit turned(view);
  fit();
}

void ContourCanvas::fit() {
  follows_fit_ = true;
  // The axes and the scale bar stand at the lower edge.
  const QSizeF room(width(), std::max(height() - kFootHeight, height() / 2));
  const double margin = std::min(kFitMargin, kMostMargin * std::min(room.width(), room.height()));
  projection_ = fitted(projection_, drawnBox(), room, margin);
  redraw();
}

/// Of what is drawn of the plan and of the one behind it.
Box ContourCanvas::drawnBox() const {
  Box box;
  for (const auto* scene : {scene_.get(), ghost_.get()}) {
    if (!scene || scene->is_empty()) continue;
    const SceneGeometry& g = *scene->geometry;
    const Box& drawn = rapids_shown_ || g.feed_box.is_empty() ? g.box : g.feed_box;
    box.add(drawn.low);
    box.add(drawn.high);
  }
  return box;
}

void ContourCanvas::setProjection(const Projection& projection) {
  follows_fit_ = false;
  projection_ = projection;
  redraw();
}

void ContourCanvas::zoomBy(double factor, const QPointF& fixed) {
  follows_fit_ = false;
  // Below this a float no longer tells neighbouring pixels apart.
  const double size = scene_ ? scene_->geometry->box.diagonal() : 0.0;
  const double most = size > 0 ? std::min(kMostScale, 4e6 / size * 16) : kMostScale;
  projection_.zoom(factor, fixed, kLeastScale, std::max(most, projection_.scale));
  moved();
}

void ContourCanvas::moved() {
  moving_ = true;
  settle_.start(kSettleMs);
  redraw();
}

void ContourCanvas::redraw() {
  stale_ = true;
  update();
}

Projection ContourCanvas::scaled(double ratio) const {
  Projection p = projection_;
  p.scale *= ratio;
  p.origin *= ratio;
  return p;
}

void ContourCanvas::drawPicture(QImage& image, const Projection& projection, double ratio, bool smooth) const {
  image.fill(theme_.surface.rgb());
  if (!scene_) return;
  {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    drawTravel(painter, projection);
    if (tolerance_ > 0 && band_shown_ && !tube_) drawBand(painter, projection);
  }
  const bool in_band = tube_ && band_shown_;
  const TubeStyle tube_style{theme_, enlargement_, 1.6 * ratio};
  const bool has_band = in_band && draw_band(image, *tube_, projection, tube_style);
  if (ghost_) {
    draw_scene(image, *ghost_, projection,
               {ColourBy::speed, nullptr, theme_.plan_b.rgb(), theme_.plan_b.rgb(), 1.4 * ratio, 6 * ratio, true,
                rapids_shown_, smooth});
  }
  SceneStyle style;
  style.by = by_;
  style.colours = scene_->can_colour_by(by_) ? &colours_ : nullptr;
  style.plain = theme_.accent.rgb();
  style.rapid = theme_.secondary.rgb();
  style.width = (smooth ? 1.8 : 1.0) * ratio;
  style.dash = 5 * ratio;
  style.smooth = smooth;
  style.rapids = rapids_shown_;
  style.cut = 4 * ratio;
  if (!smooth) style.detail = 1.3;
  if (!smooth) style.most_cuts /= 4;
  const double covered = kCovered * image.width() * image.height();
  style.most_pixels = std::max(moving_ ? kPixelsWhileMoving : kPixelsAtRest, covered);
  last_pieces_ = draw_scene(image, *scene_, projection, style);
  if (has_band) draw_inside_band(image, *tube_, projection, tube_style);
  if (showsTrace()) {
    draw_trace(image, *scene_->trace, projection, enlargement_, theme_.error.rgb(), 1.2 * ratio);
  }
  if (showsMeasured()) draw_trace(image, *measured_, projection, enlargement_, theme_.text.rgb(), 1.2 * ratio);
  if (!moving_) {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    drawDirection(painter, projection, QSizeF(image.size()), ratio);
  }
}

bool ContourCanvas::canBeSmooth(const QSize& pixels, const Projection& projection) const {
  if (!scene_) return true;
  const DrawingLoad load = drawing_load(*scene_, projection, QSizeF(pixels));
  const DrawingLoad& most = moving_ ? kSmoothWhileMoving : kSmoothAtRest;
  return load.pieces < most.pieces && load.pixels < most.pixels;
}

QImage ContourCanvas::render(const QSize& size, double scale) const {
  QImage image(size * scale, QImage::Format_RGB32);
  Projection p = projection_;
  const double ratio =
      std::min(double(size.width()) / std::max(width(), 1), double(size.height()) / std::max(height(), 1));
  p.origin =
      QPointF(size.width() / 2.0, size.height() / 2.0) + (p.origin - QPointF(width() / 2.0, height() / 2.0)) * ratio;
  p.scale *= ratio * scale;
  p.origin *= scale;
  drawPicture(image, p, scale, true);
  return image;
}

void ContourCanvas::paintEvent(QPaintEvent*) {
  const double ratio = devicePixelRatioF();
  const QSize pixels = (QSizeF(size()) * ratio).toSize();
  if (stale_ || picture_.size() != pixels) {
    if (picture_.size() != pixels) picture_ = QImage(pixels, QImage::Format_RGB32);
    const Projection projection = scaled(ratio);
    picture_.setDevicePixelRatio(1.0);
    drawPicture(picture_, projection, ratio, canBeSmooth(pixels, projection));
    picture_.setDevicePixelRatio(ratio);
    stale_ = false;
    ++pictures_drawn_;
  }
  QPainter painter(this);
  painter.drawImage(QPointF(0, 0), picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  if (!scene_ || scene_->is_empty()) return drawHint(painter);
  drawScaleBar(painter);
  drawCaption(painter);
  drawHighlight(painter);
  drawCursor(painter);
  drawHover(painter);
}

void ContourCanvas::resizeEvent(QResizeEvent* event) {
  if (follows_fit_) return fit();
  // What was in the middle stays there.
  const QSizeF before = event->oldSize().isValid() ? QSizeF(event->oldSize()) : QSizeF(size());
  projection_.pan({(width() - before.width()) / 2, (height() - before.height()) / 2});
  redraw();
}

}  // namespace toolpace::ui
