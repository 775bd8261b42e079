#include "panels/front_plot.h"

#include <algorithm>
#include <cmath>

#include "drawing/colour_map.h"
#include "plots/axis_look.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kFrontColours = 16;         // of the vibration
constexpr double kFrontReach = 16;                // px, how near the mouse has to be
constexpr double kManyTimesApart = 5;             // beyond, an axis is logarithmic
constexpr double kDecadesApart = 100;             // and beyond, by tens and no twos
constexpr double kFrontMargin = 0.08;             // of an axis, around the points
constexpr double kLeastShareShown = 1e-3;         // of a value, that an axis shows at least
constexpr int kLeastFrontHeight = 160;            // px
constexpr double kFrontDot = 7, kFrontRing = 14;  // px

/// All points that are drawn: those of the front and the settings that the search began with.
std::vector<Objectives> all_points(const toolpace::TuneResult& tuning) {
  std::vector<Objectives> all = {tuning.present.objectives};
  for (const Tuned& t : tuning.front) all.push_back(t.objectives);
  return all;
}

std::pair<double, double> vibration_range(const toolpace::TuneResult& tuning) {
  double low = 1e300, high = 0;
  for (const Tuned& t : tuning.front) {
    low = std::min(low, *t.objectives.vibration);
    high = std::max(high, *t.objectives.vibration);
  }
  return {low, std::max(high, low + 1e-9)};
}

bool knows_vibration(const toolpace::TuneResult& tuning) {
  return !tuning.front.empty() && tuning.front.front().objectives.vibration.has_value();
}

QCPRange range_around(double low, double high) {
  const double margin = std::max((high - low) * kFrontMargin, high * kLeastShareShown);
  return {low - margin, high + margin};
}

/// Logarithmic where the values are many times apart: the quick ones would lie on each other.
void fit_axis(QCPAxis& axis, double low, double high) {
  const bool many = low > 0 && high > kManyTimesApart * low;
  axis.setScaleType(many ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
  if (!many) {
    axis.setTicker(QSharedPointer<QCPAxisTicker>::create());
    return axis.setRange(range_around(low, high));
  }
  const QSharedPointer<QCPAxisTickerLog> ticker(new QCPAxisTickerLog);
  ticker->setLogBase(high > kDecadesApart * low ? 10 : 2);
  axis.setTicker(ticker);
  const double factor = std::pow(high / low, kFrontMargin);
  axis.setRange(low / factor, high * factor);
}

}  // namespace

FrontPlot::FrontPlot(QWidget* parent)
    : QCustomPlot(parent),
      steps_(addGraph()),
      hover_(addGraph()),
      used_(addGraph()),
      limit_(new QCPItemStraightLine(this)),
      limit_text_(new QCPItemText(this)),
      used_text_(new QCPItemText(this)) {
  setObjectName("frontPlot");
  setMinimumHeight(kLeastFrontHeight);
  setMouseTracking(true);
  steps_->setLineStyle(QCPGraph::lsStepLeft);
  for (QCPGraph* ring : {hover_, used_}) ring->setLineStyle(QCPGraph::lsNone);
  for (std::size_t i = 0; i < kFrontColours; ++i) {
    points_.push_back(addGraph());
    points_.back()->setLineStyle(QCPGraph::lsNone);
  }
  limit_text_->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
  limit_text_->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  limit_text_->position->setTypeY(QCPItemPosition::ptPlotCoords);
  used_text_->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
  for (QCPItemText* text : {limit_text_, used_text_}) text->setPadding({4, 2, 4, 2});
  setTheme(theme_);
  retranslate();
}

void FrontPlot::setTuning(std::shared_ptr<const toolpace::TuneResult> tuning, bool stale) {
  if (tuning == tuning_ && stale == stale_) return;
  if (tuning != tuning_) setHovered(std::nullopt);
  tuning_ = std::move(tuning);
  stale_ = stale;
  draw();
}

void FrontPlot::setUsed(const std::optional<Objectives>& used) {
  used_at_ = used;
  drawMarks();
  replot(rpQueuedReplot);
}

QPointF FrontPlot::coordinates(const Objectives& o) const {
  return {o.cycle_time, o.contour * error_unit(units_).factor};
}

QPointF FrontPlot::placeOf(std::size_t index) const {
  const QPointF at = coordinates(tuning_->front[index].objectives);
  return {xAxis->coordToPixel(at.x()), yAxis->coordToPixel(at.y())};
}

void FrontPlot::draw() {
  drawPoints();
  fitAxes();
  showScale();
  drawMarks();
  replot(rpQueuedReplot);
}

void FrontPlot::drawPoints() {
  steps_->data()->clear();
  for (QCPGraph* graph : points_) graph->data()->clear();
  if (!tuning_) return;
  const bool coloured = knows_vibration(*tuning_) && !stale_;
  const auto [low, high] = coloured ? vibration_range(*tuning_) : std::pair(0.0, 1.0);
  const ColourTable table = colour_table(ColourMap::cividis, theme_.dark ? Ground::dark : Ground::light);
  std::vector<Objectives> front;
  for (const Tuned& t : tuning_->front) front.push_back(t.objectives);
  for (const std::size_t i : pareto_front(front, Flaw::contour)) {  // others are there for their vibration alone
    const QPointF at = coordinates(front[i]);
    steps_->addData(at.x(), at.y());
  }
  for (const Tuned& t : tuning_->front) {
    const QPointF at = coordinates(t.objectives);
    const double level = coloured ? (*t.objectives.vibration - low) / (high - low) : 0;
    points_[std::min(kFrontColours - 1, static_cast<std::size_t>(level * kFrontColours))]->addData(at.x(), at.y());
  }
  for (std::size_t i = 0; i < kFrontColours; ++i) {
    const QColor colour = stale_     ? theme_.secondary
                          : coloured ? QColor(table[i * 255 / (kFrontColours - 1)])
                                     : theme_.accent;
    points_[i]->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, kFrontDot));
  }
}

void FrontPlot::drawMarks() {
  hover_->data()->clear();
  used_->data()->clear();
  for (QCPAbstractItem* item : {static_cast<QCPAbstractItem*>(limit_), static_cast<QCPAbstractItem*>(limit_text_),
                                static_cast<QCPAbstractItem*>(used_text_)}) {
    item->setVisible(tuning_ != nullptr);
  }
  if (!tuning_) return;
  const double limit = tuning_->limits.contour * error_unit(units_).factor;
  limit_->point1->setCoords(0, limit);
  limit_->point2->setCoords(1, limit);
  limit_text_->position->setCoords(1, limit);
  if (hovered_) {
    const QPointF at = coordinates(tuning_->front[*hovered_].objectives);
    hover_->addData(at.x(), at.y());
  }
  used_text_->setVisible(used_at_.has_value());
  if (!used_at_) return;
  const QPointF at = coordinates(*used_at_);
  used_->addData(at.x(), at.y());
  used_text_->position->setCoords(at.x(), at.y());
  // To the side where there is room.
  const bool right = xAxis->coordToPixel(at.x()) > axisRect()->center().x();
  used_text_->setPositionAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
}

void FrontPlot::fitAxes() {
  if (!tuning_) return;
  double first = 1e300, last = 0, least = 1e300, most = 0;
  for (const Objectives& o : all_points(*tuning_)) {
    const QPointF at = coordinates(o);
    first = std::min(first, at.x());
    last = std::max(last, at.x());
    least = std::min(least, at.y());
    most = std::max(most, at.y());
  }
  fit_axis(*xAxis, first, last);
  fit_axis(*yAxis, least, most);
}

/// What the colours mean stands beside the plot, while they mean something.
void FrontPlot::showScale() {
  const bool coloured = tuning_ && knows_vibration(*tuning_) && !stale_;
  if (!coloured) {
    if (scale_) plotLayout()->remove(scale_);
    plotLayout()->simplify();
    scale_ = nullptr;
    return;
  }
  if (!scale_) {
    scale_ = new QCPColorScale(this);
    scale_->setBarWidth(10);
    plotLayout()->addElement(0, 1, scale_);
  }
  const ColourTable table = colour_table(ColourMap::cividis, theme_.dark ? Ground::dark : Ground::light);
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (std::size_t i = 0; i < table.size(); i += 15) {
    gradient.setColorStopAt(static_cast<double>(i) / 255, QColor(table[i]));
  }
  scale_->setGradient(gradient);
  const auto [low, high] = vibration_range(*tuning_);
  const DisplayUnit unit = error_unit(units_);
  scale_->setDataRange({low * unit.factor, high * unit.factor});
  scale_->setLabel(tr("vibration left by stops") + "  " + unit.text);
  dressAxis(*scale_->axis(), theme_, font());
}

std::optional<std::size_t> FrontPlot::near(const QPointF& at) const {
  if (!tuning_ || stale_) return std::nullopt;
  std::optional<std::size_t> nearest;
  double least = kFrontReach;
  for (std::size_t i = 0; i < tuning_->front.size(); ++i) {
    const QPointF away = placeOf(i) - at;
    const double distance = std::hypot(away.x(), away.y());
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

void FrontPlot::setHovered(std::optional<std::size_t> index) {
  if (index == hovered_) return;
  hovered_ = index;
  setCursor(index ? Qt::PointingHandCursor : Qt::ArrowCursor);
  drawMarks();
  replot(rpQueuedReplot);
  emit hovered(index);
}

void FrontPlot::mouseMoveEvent(QMouseEvent* event) {
  setHovered(near(event->position()));
  QCustomPlot::mouseMoveEvent(event);
}

void FrontPlot::mousePressEvent(QMouseEvent* event) {
  const auto index = near(event->position());
  if (event->button() == Qt::LeftButton && index) emit chosen(*index);
  QCustomPlot::mousePressEvent(event);
}

void FrontPlot::leaveEvent(QEvent* event) {
  setHovered(std::nullopt);
  QCustomPlot::leaveEvent(event);
}

void FrontPlot::setUnits(Units units) {
  units_ = units;
  retranslate();
  draw();
}

void FrontPlot::setTheme(const Theme& theme) {
  theme_ = theme;
  setBackground(theme.surface);
  for (QCPAxis* axis : {xAxis, yAxis}) dressAxis(*axis, theme, font());
  steps_->setPen(QPen(theme.secondary, 1));
  hover_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(theme.accent, 2), Qt::NoBrush, kFrontRing));
  used_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(theme.plan_b, 2), Qt::NoBrush, kFrontRing));
  limit_->setPen(QPen(theme.warning, 1, Qt::DashLine));
  limit_text_->setColor(theme.warning);
  used_text_->setColor(theme.plan_b);
  for (QCPItemText* text : {limit_text_, used_text_}) text->setFont(font());
  draw();
}

void FrontPlot::retranslate() {
  name_control(this, tr("Cycle time against contour error of the best settings"),
               tr("Click on a point to take its settings"));
  xAxis->setLabel(tr("cycle time") + "  s");
  yAxis->setLabel(tr("contour error") + "  " + error_unit(units_).text);
  limit_text_->setText(tr("limit"));
  used_text_->setText(tr("in use"));
  replot(rpQueuedReplot);
}

}  // namespace toolpace::ui
