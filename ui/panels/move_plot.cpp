#include "panels/move_plot.h"

#include <algorithm>
#include <cmath>

#include "models/units.h"
#include "plots/axis_look.h"
#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr int kStripHeight = 56;  // room for a duration that stands upright
constexpr int kRowSpacing = 4;
constexpr int kRowMargin = 6;
constexpr int kLabelMargin = 4;
constexpr double kHeadroom = 0.08;
constexpr double kShade = 0.10;

void set_range(QCPAxis* axis, double low, double high) {
  const double span = high > low ? high - low : std::max(std::abs(high), 1.0);
  axis->setRange(low - (low < 0 ? kHeadroom * span : 0.0), high + kHeadroom * span);
}

}  // namespace

MovePlot::MovePlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName("movePlot");
  setMinimumSize(320, 320);
  plotLayout()->clear();
  plotLayout()->setRowSpacing(kRowSpacing);
  auto* margins = new QCPMarginGroup(this);
  strip_ = new QCPAxisRect(this, true);
  strip_->setMinimumSize(10, kStripHeight);
  strip_->setMaximumSize(QWIDGETSIZE_MAX, kStripHeight);
  strip_->setAutoMargins(QCP::msLeft | QCP::msRight);
  strip_->setMargins(QMargins(0, 0, 0, 0));
  strip_->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  for (auto* axis : strip_->axes()) axis->setVisible(false);
  strip_->axis(QCPAxis::atLeft)->setRange(0, 1);
  plotLayout()->addElement(0, 0, strip_);
  for (std::size_t i = 0; i < kRows; ++i) {
    buildRow(i);
    rows_[i].rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  }
  feed_ = addGraph(rows_[0].rect->axis(QCPAxis::atBottom), rows_[0].rect->axis(QCPAxis::atLeft));
  setTheme(theme_);
  retranslate();
}

void MovePlot::buildRow(std::size_t index) {
  Row& row = rows_[index];
  row.rect = new QCPAxisRect(this, true);
  row.rect->setupFullAxesBox(true);
  row.rect->setMinimumMargins(QMargins(0, kRowMargin, kRowMargin, kRowMargin));
  plotLayout()->addElement(static_cast<int>(index) + 1, 0, row.rect);
  QCPAxis* time = row.rect->axis(QCPAxis::atBottom);
  time->setTickLabels(index + 1 == kRows);
  row.curve = addGraph(time, row.rect->axis(QCPAxis::atLeft));
  row.rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(4);
}

void MovePlot::setMove(const MovePreview& preview, double feed) {
  const auto vector = [](const std::vector<double>& values) { return QVector<double>(values.begin(), values.end()); };
  const QVector<double> time = vector(preview.time);
  const std::array curves{&preview.speed, &preview.acceleration, &preview.jerk, &preview.distance};
  for (std::size_t i = 0; i < kRows; ++i) rows_[i].curve->setData(time, vector(*curves[i]), true);
  feed_->setData({0.0, preview.end()}, {feed, feed}, true);
  phases_ = preview.phases;
  setRanges(preview, feed);
  buildBands();
  fitLabels();
  replot(rpQueuedReplot);
}

void MovePlot::clearMove() {
  for (Row& row : rows_) row.curve->data()->clear();
  feed_->data()->clear();
  phases_.clear();
  clearBands();
  replot(rpQueuedReplot);
}

void MovePlot::setRanges(const MovePreview& preview, double feed) {
  const auto extent = [](const std::vector<double>& values) {
    if (values.empty()) return std::pair{0.0, 1.0};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return std::pair{std::min(*low, 0.0), std::max(*high, 0.0)};
  };
  const double end = preview.end() > 0 ? preview.end() : 1.0;
  for (Row& row : rows_) row.rect->axis(QCPAxis::atBottom)->setRange(0, end);
  strip_->axis(QCPAxis::atBottom)->setRange(0, end);
  const std::array curves{&preview.speed, &preview.acceleration, &preview.jerk, &preview.distance};
  for (std::size_t i = 0; i < kRows; ++i) {
    const auto [low, high] = extent(*curves[i]);
    set_range(rows_[i].rect->axis(QCPAxis::atLeft), low, i == 0 ? std::max(high, feed) : high);
  }
}

void MovePlot::clearBands() {
  for (Band& band : bands_) {
    for (auto* shade : band.shades) removeItem(shade);
    removeItem(band.label);
  }
  bands_.clear();
}

void MovePlot::buildBands() {
  clearBands();
  for (const MovePhase& phase : phases_) {
    Band band{{}, new QCPItemText(this), phase};
    for (std::size_t i = 0; i < kRows; ++i) {
      auto* shade = new QCPItemRect(this);
      QCPAxisRect* rect = rows_[i].rect;
      shade->setClipAxisRect(rect);
      for (QCPItemPosition* corner : {shade->topLeft, shade->bottomRight}) {
        corner->setTypeX(QCPItemPosition::ptPlotCoords);
        corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
        corner->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
        corner->setAxisRect(rect);
      }
      shade->topLeft->setCoords(phase.begin, 0);
      shade->bottomRight->setCoords(phase.begin + phase.duration, 1);
      shade->setLayer("background");
      band.shades[i] = shade;
    }
    band.label->position->setAxes(strip_->axis(QCPAxis::atBottom), strip_->axis(QCPAxis::atLeft));
    band.label->position->setAxisRect(strip_);
    band.label->setClipToAxisRect(false);
    band.label->position->setCoords(phase.begin + phase.duration / 2, 0.5);
    band.label->setText(number_text(phase.duration, 5));
    bands_.push_back(band);
  }
  dressBands();
}

/// A label stands upright where it is wider than its phase, and is left out where it would touch the one before.
void MovePlot::fitLabels() {
  if (bands_.empty()) return;
  replot(rpImmediateRefresh);  // lays the axes out
  const QFontMetrics metrics(font());
  const QCPAxis* axis = strip_->axis(QCPAxis::atBottom);
  double taken = -1e9;  // right edge of the last label [px]
  for (Band& band : bands_) {
    const double left = axis->coordToPixel(band.phase.begin);
    const double right = axis->coordToPixel(band.phase.begin + band.phase.duration);
    const double flat_width = metrics.horizontalAdvance(band.label->text()) + kLabelMargin;
    const bool is_flat = flat_width <= right - left;
    const double half = (is_flat ? flat_width : metrics.height()) / 2;
    const double middle = (left + right) / 2;
    band.label->setRotation(is_flat ? 0 : -90);
    band.label->setVisible(middle - half >= taken);
    if (band.label->visible()) taken = middle + half;
  }
}

QStringList MovePlot::phaseLabels() const {
  QStringList labels;
  for (const Band& band : bands_) labels << (band.label->visible() ? band.label->text() : QString());
  return labels;
}

QColor MovePlot::shadeOf(MovePhase::Kind kind) const {
  switch (kind) {
    case MovePhase::Kind::speeding_up: return mixed(theme_.surface, theme_.accent, kShade);
    case MovePhase::Kind::slowing_down: return mixed(theme_.surface, theme_.plan_b, kShade);
    case MovePhase::Kind::cruise: break;
  }
  return mixed(theme_.surface, theme_.secondary, kShade / 2);
}

void MovePlot::dressBands() {
  for (Band& band : bands_) {
    for (auto* shade : band.shades) {
      shade->setPen(QPen(theme_.line, 1));
      shade->setBrush(shadeOf(band.phase.kind));
    }
    band.label->setColor(theme_.text);
    band.label->setFont(font());
  }
}

void MovePlot::setTheme(const Theme& theme) {
  theme_ = theme;
  setBackground(theme.surface);
  for (Row& row : rows_) {
    for (auto* axis : row.rect->axes()) {
      dressAxis(*axis, theme, font());
      axis->grid()->setZeroLinePen(QPen(theme.secondary, 1));
    }
    row.curve->setPen(QPen(theme.accent, 1.5));
  }
  feed_->setPen(QPen(theme.secondary, 1, Qt::DashLine));
  dressBands();
  replot(rpQueuedReplot);
}

void MovePlot::setUnits(MoveUnits units) {
  units_ = units;
  retranslate();
}

void MovePlot::retranslate() {
  const std::array<std::pair<QString, MoveQuantity>, kRows> titles{{{tr("v"), MoveQuantity::speed},
                                                                    {tr("a"), MoveQuantity::acceleration},
                                                                    {tr("j"), MoveQuantity::jerk},
                                                                    {tr("s"), MoveQuantity::length}}};
  for (std::size_t i = 0; i < kRows; ++i) {
    rows_[i].rect->axis(QCPAxis::atLeft)->setLabel(titles[i].first + "  " + move_unit_text(titles[i].second, units_));
  }
  rows_.back().rect->axis(QCPAxis::atBottom)->setLabel(tr("t") + "  " + move_unit_text(MoveQuantity::time, units_));
  setAccessibleName(tr("Speed, acceleration, jerk and distance of the move over time"));
  setToolTip(tr("The numbers above are the durations of the phases"));
  replot(rpQueuedReplot);
}

void MovePlot::resizeEvent(QResizeEvent* event) {
  QCustomPlot::resizeEvent(event);
  fitLabels();
}

}  // namespace toolpace::ui
