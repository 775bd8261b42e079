#include "plots/profile_plot.h"

#include <QElapsedTimer>
#include <cmath>

namespace toolpace::ui {
namespace {

constexpr double kLeastSpan = 1e-7;  // of the plan
constexpr std::array kQuantities = {Quantity::speed, Quantity::acceleration, Quantity::jerk};
constexpr std::array<const char*, 3> kSymbols = {"v", "a", "j"};
constexpr const char* kCursorLayer = "cursor";

const Extent& extent_of(const MotionExtent& e, std::size_t row) {
  return row == 0 ? e.speed : row == 1 ? e.acceleration : e.jerk;
}
const Curve& curve_of(const MotionCurves& c, std::size_t row) {
  return row == 0 ? c.speed : row == 1 ? c.acceleration : c.jerk;
}

void fill(QCPGraph* graph, const Curve& curve, double factor) {
  QVector<QCPGraphData> points(curve.time.size());
  for (qsizetype i = 0; i < curve.time.size(); ++i) points[i] = {curve.time[i], curve.value[i] * factor};
  graph->data()->set(points, true);
}

/// "10³ mm/s³" keeps the numbers at the axis short.
double power_of_thousand(double largest) {
  if (!(largest >= 1e4) || !std::isfinite(largest)) return 1.0;
  return std::pow(1000.0, std::floor(std::log10(largest / 10) / 3));
}

QString power_text(double power) {
  if (power == 1.0) return {};
  static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString text = QStringLiteral("10");
  for (const QChar c : QString::number(std::lround(std::log10(power)))) text += digits[c.digitValue()];
  return text + ' ';
}

}  // namespace

ProfilePlot::ProfilePlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName("profilePlot");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
  setNoAntialiasingOnDrag(false);
  setNotAntialiasedElements(QCP::aeAll);
  setAntialiasedElements(QCP::aePlottables | QCP::aeOther);
  plotLayout()->clear();
  plotLayout()->setRowSpacing(0);
  plotLayout()->setMargins(QMargins(0, 4, 0, 0));
  for (std::size_t i = 0; i < kPlots; ++i) buildRow(i);
  time_title_ = new QCPItemText(this);
  time_title_->position->setType(QCPItemPosition::ptAbsolute);
  time_title_->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_title_->setClipToAxisRect(false);
  addLayer(kCursorLayer, layer("overlay"), QCustomPlot::limBelow);
  layer(kCursorLayer)->setMode(QCPLayer::lmBuffered);
  cursor_ = new CursorLayer(this, kCursorLayer);
  buildErrorRow();
  connect(this, &QCustomPlot::afterLayout, this, &ProfilePlot::laidOut);
  retranslate();
  dress();
}

void ProfilePlot::buildRow(std::size_t index) {
  Row& row = rows_[index];
  row.rect = new QCPAxisRect(this, true);
  plotLayout()->addElement(static_cast<int>(index), 0, row.rect);
  row.rect->setAutoMargins(QCP::msNone);
  row.value = row.rect->axis(QCPAxis::atLeft);
  QCPAxis* time = row.rect->axis(QCPAxis::atBottom);
  time_axes_.push_back(time);
  time->ticker()->setTickCount(8);
  row.value->ticker()->setTickCount(4);
  row.value->setNumberFormat("gb");
  row.value->setNumberPrecision(6);
  const auto graph = [&](const char* name) {
    auto* g = addGraph(time, row.value);
    g->setName(QString("%1.%2").arg(kSymbols[index]).arg(name));
    g->setSelectable(QCP::stNone);
    return g;
  };
  row.feed = graph("feed");
  row.cap_high = graph("cap");
  row.cap_low = graph("cap below");
  row.ghost = graph("ghost");
  row.ghost_low = graph("ghost below");
  for (auto& axis : row.axis) axis = graph("axis");
  row.curve = graph("curve");
}

void ProfilePlot::buildErrorRow() {
  error_rect_ = new QCPAxisRect(this, true);
  error_rect_->setAutoMargins(QCP::msNone);
  plotLayout()->addElement(static_cast<int>(kPlots), 0, error_rect_);
  QCPAxis* time = error_rect_->axis(QCPAxis::atBottom);
  time->ticker()->setTickCount(8);
  time_axes_.push_back(time);
  error_curve_ = addGraph(time, error_rect_->axis(QCPAxis::atLeft));
  error_curve_->setName("e.curve");
  error_curve_->setSelectable(QCP::stNone);
  setErrorShown(false);
}

void ProfilePlot::setErrorShown(bool shown) {
  const bool was = plotLayout()->elementCount() > static_cast<int>(kPlots);
  if (was && !shown) {
    plotLayout()->take(error_rect_);
    plotLayout()->simplify();
  } else if (!was && shown) {
    plotLayout()->addElement(static_cast<int>(kPlots), 0, error_rect_);
  }
  error_rect_->setVisible(shown);
  error_curve_->setVisible(shown);
  layOut();
  refill();
}

void ProfilePlot::setErrorTrace(std::shared_ptr<const ErrorTrace> trace) {
  error_ = SampleSeries(std::move(trace));
  updateErrorScale();
  refill();
}

/// Contour errors are micrometres; in inches they are thousandths.
double ProfilePlot::errorFactor() const {
  return unit_ == LengthUnit::mm ? 1000.0 : 1000.0 * display_unit(Quantity::length, unit_).factor;
}

void ProfilePlot::updateErrorScale() {
  const double most = error_.largest() * errorFactor();
  QCPAxis* axis = error_rect_->axis(QCPAxis::atLeft);
  // Between two simulations the old heights stay, so that the plot does not jump.
  if (!error_.is_empty()) axis->setRange(most > 0 ? -0.03 * most : -0.03, most > 0 ? 1.09 * most : 1.0);
  axis->setLabel(unit_ == LengthUnit::mm ? QStringLiteral("e\nµm") : QStringLiteral("e\n10⁻³ in"));
}

void ProfilePlot::setTheme(const Theme& theme) {
  theme_ = theme;
  dress();
}

void ProfilePlot::setUnit(LengthUnit unit) {
  unit_ = unit;
  updateScales();
  refill();
}

void ProfilePlot::retranslate() { updateScales(); }

void ProfilePlot::dress() {
  setBackground(theme_.surface);
  cursor_->theme = theme_;
  for (auto& row : rows_) dressRow(row);
  dressRect(error_rect_);
  error_curve_->setPen(QPen(theme_.error, 1.2));
  time_title_->setColor(theme_.secondary);
  time_title_->setFont(font());
  replot(rpQueuedReplot);
}

void ProfilePlot::dressRect(QCPAxisRect* rect) {
  QColor faint = theme_.line;
  faint.setAlphaF(0.7f);
  QCPAxis* value = rect->axis(QCPAxis::atLeft);
  for (auto* axis : {value, rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atRight), rect->axis(QCPAxis::atTop)}) {
    axis->setVisible(true);
    axis->setBasePen(QPen(theme_.line, 1));
    axis->setTickPen(QPen(theme_.line, 1));
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(theme_.secondary);
    axis->setLabelColor(theme_.text);
    axis->setTickLabelFont(font());
    axis->setLabelFont(font());
    axis->setLabelPadding(0);
    axis->setTickLabelPadding(4);
    axis->grid()->setPen(QPen(faint, 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
    axis->setTickLengthIn(0);
    axis->setTickLengthOut(axis == value ? 4 : 0);
  }
  value->grid()->setZeroLinePen(QPen(theme_.secondary, 1));
  rect->axis(QCPAxis::atRight)->setTicks(false);
  rect->axis(QCPAxis::atTop)->setTicks(false);
}

void ProfilePlot::dressRow(Row& row) {
  dressRect(row.rect);
  QColor ghost_feed = theme_.secondary;
  ghost_feed.setAlphaF(0.4f);
  row.feed->setPen(QPen(ghost_feed, 2));
  QPen cap_pen(theme_.secondary, 1);
  cap_pen.setDashPattern({6, 4});
  for (auto* cap : {row.cap_high, row.cap_low}) cap->setPen(cap_pen);
  for (auto* ghost : {row.ghost, row.ghost_low}) ghost->setPen(QPen(theme_.plan_b, 1.3, Qt::DashLine));
  row.curve->setPen(QPen(theme_.accent, 1.6));
  const std::array<QPen, kAxes> pens = {QPen(theme_.axis_x, 1.2), QPen(theme_.axis_y, 1.2, Qt::DashLine),
                                        QPen(theme_.axis_z, 1.2, Qt::DotLine)};
  for (std::size_t i = 0; i < kAxes; ++i) row.axis[i]->setPen(pens[i]);
}

double ProfilePlot::duration() const { return series_ && !series_->is_empty() ? series_->duration() : 1.0; }

void ProfilePlot::setSeries(std::shared_ptr<const ProfileSeries> series) {
  const double before = duration();
  const bool whole = !series_ || series_->is_empty() || (range().lower <= 0 && range().upper >= before);
  series_ = std::move(series);
  updateScales();
  whole ? fit() : setRange(range().lower, range().upper);
  refill();
}

void ProfilePlot::setGhost(std::shared_ptr<const ProfileSeries> series) {
  ghost_ = std::move(series);
  updateScales();
  refill();
}

void ProfilePlot::setAxisShown(std::size_t axis, bool shown) {
  shown_.at(axis) = shown;
  updateScales();
  refill();
}

// The whole plan decides, not the visible part: zooming in time leaves the heights alone, so they can be compared.
void ProfilePlot::updateScales() {
  for (std::size_t i = 0; i < kPlots; ++i) {
    Row& row = rows_[i];
    const DisplayUnit unit = display_unit(kQuantities[i], unit_);
    Extent extent;
    extent.add(0.0f);
    for (const auto* s : {series_.get(), ghost_.get()}) {
      if (s && !s->is_empty()) extent.add(extent_of(s->whole, i));
    }
    // An axis may brake while the path speed is steady; its values never exceed the path's on lines, but turn round.
    const bool any_axis = shown_[0] || shown_[1] || shown_[2];
    if (any_axis) extent.low = std::min(extent.low, -extent.high);
    if (any_axis) extent.high = std::max(extent.high, -extent.low);
    double low = extent.low * unit.factor, high = extent.high * unit.factor;
    if (!(high > low) || !std::isfinite(high - low)) (low = 0, high = 1);
    const double power = power_of_thousand(std::max(-low, high));
    row.factor = unit.factor / power;
    const double margin = 0.09 * (high - low);
    row.value->setRange((low - (low < 0 ? margin : 0.03 * (high - low))) / power, (high + margin) / power);
    row.value->setLabel(QString("%1\n%2%3").arg(kSymbols[i], power_text(power), unit.text));
  }
  time_title_->setText(tr("t  s"));
  updateErrorScale();
}

void ProfilePlot::setRange(double begin, double end) {
  const double total = duration(), least = std::max(total * kLeastSpan, 1e-9);
  const double margin = total * 0.01;
  double width = std::clamp(end - begin, least, total + 2 * margin);
  if (!std::isfinite(width) || !std::isfinite(begin)) return;
  const double low = std::clamp(begin, -margin, std::max(total + margin - width, -margin));
  for (auto* axis : time_axes_) axis->setRange(low, low + width);
  refill();
  emit rangeChanged(low, low + width);
}

void ProfilePlot::fit() {
  const double total = duration();
  setRange(-0.01 * total, 1.01 * total);
}

void ProfilePlot::zoom(double factor, double around) {
  const QCPRange now = range();
  const double width = now.size() / factor, share = (around - now.lower) / now.size();
  setRange(around - width * share, around + width * (1 - share));
}

void ProfilePlot::refill() {
  QElapsedTimer clock;
  clock.start();
  const QCPRange now = range();
  const TimeWindow window{now.lower, now.upper,
                          std::max(static_cast<int>(rows_[0].rect->width() * bufferDevicePixelRatio()), 16)};
  const MotionCurves own = series_ ? motion_curves(*series_, window) : MotionCurves{};
  const bool dense = series_ && is_dense(*series_, window);
  const MotionEnvelope other = ghost_ ? motion_envelope(*ghost_, window) : MotionEnvelope{};
  const CapCurves caps = series_ ? cap_curves(*series_, window) : CapCurves{};
  for (std::size_t i = 0; i < kPlots; ++i) {
    fill(rows_[i].curve, curve_of(own, i), rows_[i].factor);
    rows_[i].curve->setPen(QPen(theme_.accent, dense ? 1.0 : 1.6));
    fill(rows_[i].ghost, curve_of(other.high, i), rows_[i].factor);
    fill(rows_[i].ghost_low, curve_of(other.low, i), rows_[i].factor);
  }
  fill(rows_[0].feed, caps.feed, rows_[0].factor);
  fill(rows_[0].cap_high, caps.speed, rows_[0].factor);
  fill(rows_[1].cap_high, caps.acceleration_high, rows_[1].factor);
  fill(rows_[1].cap_low, caps.acceleration_low, rows_[1].factor);
  fill(rows_[2].cap_high, caps.jerk_high, rows_[2].factor);
  fill(rows_[2].cap_low, caps.jerk_low, rows_[2].factor);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const MotionCurves curves = shown_[axis] && series_ ? axis_curves(*series_, window, axis) : MotionCurves{};
    for (std::size_t i = 0; i < kPlots; ++i) fill(rows_[i].axis[axis], curve_of(curves, i), rows_[i].factor);
  }
  fill(error_curve_, error_.curve(window), errorFactor());
  updateMarks();
  last_replot_ms_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  replot(rpQueuedReplot);
}

void ProfilePlot::updateMarks() {
  cursor_->marks.clear();
  if (!cursor_->time || !series_ || series_->is_empty()) return;
  const PhaseState s = motion_at(series_->outcome->plan, *cursor_->time);
  const std::array values = {s.speed, s.acceleration, s.jerk};
  for (std::size_t i = 0; i < kPlots; ++i) {
    cursor_->marks.push_back({rows_[i].value, values[i] * rows_[i].factor, theme_.accent});
  }
  if (!error_.is_empty() && error_rect_->visible()) {
    const double error = error_.at(*cursor_->time) * errorFactor();
    cursor_->marks.push_back({error_rect_->axis(QCPAxis::atLeft), error, theme_.error});
  }
}

void ProfilePlot::setCursorTime(std::optional<double> time) {
  cursor_->time = time;
  updateMarks();
  layer(kCursorLayer)->replot();
}

void ProfilePlot::setMeasures(std::optional<double> first, std::optional<double> second) {
  cursor_->measures = {first, second};
  layer(kCursorLayer)->replot();
}

std::pair<double, double> ProfilePlot::edges() const { return {rows_[0].rect->left(), rows_[0].rect->right() + 1.0}; }

double ProfilePlot::timeAt(double x) const { return time_axes_.front()->pixelToCoord(x); }

std::optional<std::size_t> ProfilePlot::measureAt(double x) const {
  for (std::size_t i = 0; i < 2; ++i) {
    if (cursor_->measures[i] && std::abs(cursor_->xOf(*cursor_->measures[i]) - x) < 6) return i;
  }
  return std::nullopt;
}

void ProfilePlot::wheelEvent(QWheelEvent* event) {
  const QPoint delta = event->angleDelta();
  const double x = event->position().x();
  event->accept();
  if (delta.x() != 0 || (event->modifiers() & Qt::ShiftModifier)) {
    const double notches = (delta.x() != 0 ? delta.x() : delta.y()) / 120.0, step = range().size() * 0.1 * notches;
    return setRange(range().lower - step, range().upper - step);
  }
  if (x < edges().first) {
    for (auto& row : rows_) {
      if (row.rect->top() <= event->position().y() && event->position().y() <= row.rect->bottom()) {
        row.value->scaleRange(std::pow(0.85, delta.y() / 120.0), 0.0);
      }
    }
    return replot(rpQueuedReplot);
  }
  zoom(std::pow(1.3, delta.y() / 120.0), timeAt(x));
}

void ProfilePlot::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->position();
  pressed_begin_ = range().lower;
  dragging_ = false;
  dragged_measure_ = event->button() == Qt::LeftButton ? measureAt(event->position().x()) : std::nullopt;
  setFocus(Qt::MouseFocusReason);
}

void ProfilePlot::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (event->buttons() == Qt::NoButton) return setCursor(measureAt(x) ? Qt::SizeHorCursor : Qt::ArrowCursor);
  if (!dragging_ && (event->position() - pressed_at_).manhattanLength() < 4) return;
  dragging_ = true;
  if (dragged_measure_) {
    cursor_->measures[*dragged_measure_] = std::clamp(timeAt(x), 0.0, duration());
    layer(kCursorLayer)->replot();
    if (cursor_->measures[0] && cursor_->measures[1]) emit measured(*cursor_->measures[0], *cursor_->measures[1]);
    return;
  }
  const double width = range().size(), shift = (x - pressed_at_.x()) / (edges().second - edges().first) * width;
  setRange(pressed_begin_ - shift, pressed_begin_ - shift + width);
}

void ProfilePlot::mouseReleaseEvent(QMouseEvent* event) {
  const double x = event->position().x();
  const bool clicked = !dragging_ && event->button() == Qt::LeftButton && x >= edges().first && x <= edges().second;
  dragging_ = false;
  if (clicked && !dragged_measure_ && series_ && !series_->is_empty()) {
    emit timeClicked(std::clamp(timeAt(x), 0.0, duration()));
  }
  dragged_measure_.reset();
}

void ProfilePlot::mouseDoubleClickEvent(QMouseEvent*) {
  updateScales();
  fit();
}

void ProfilePlot::keyPressEvent(QKeyEvent* event) {
  const QCPRange now = range();
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoom(1.5, cursor_->time.value_or(now.center()));
    case Qt::Key_Minus: return zoom(1 / 1.5, cursor_->time.value_or(now.center()));
    case Qt::Key_PageUp: return setRange(now.lower - now.size() / 2, now.upper - now.size() / 2);
    case Qt::Key_PageDown: return setRange(now.lower + now.size() / 2, now.upper + now.size() / 2);
    case Qt::Key_F: return fit();
    default: QCustomPlot::keyPressEvent(event);
  }
}

/// All plots equally high, the last one with the numbers of the time axis below it, their title where the titles of the
/// strips stand.
void ProfilePlot::layOut() {
  const QFontMetrics metrics(font());
  const int line = metrics.height(), left = metrics.horizontalAdvance("-0000") + 2 * line + 16, below = line + 6;
  const auto rects = axisRects();
  const double each = std::max((height() - below - 2.0) / static_cast<double>(rects.size()), 20.0);
  QList<double> shares;
  for (qsizetype i = 0; i < rects.size(); ++i) {
    const bool last = i + 1 == rects.size();
    rects[i]->setMargins(QMargins(left, i == 0 ? 2 : 6, 12, last ? below : 2));
    rects[i]->axis(QCPAxis::atBottom)->setTickLabels(last);
    rects[i]
        ->axis(QCPAxis::atLeft)
        ->ticker()
        ->setTickCount(std::clamp(static_cast<int>((each - 8) / (line * 1.4)), 2, 5));
    shares.append(last ? each + below : each);
  }
  plotLayout()->setRowStretchFactors(shares);
  time_title_->position->setCoords(left - 30.0, height() - below / 2.0 - 1);
}

void ProfilePlot::resizeEvent(QResizeEvent* event) {
  layOut();
  QCustomPlot::resizeEvent(event);
  refill();
}

}  // namespace toolpace::ui
