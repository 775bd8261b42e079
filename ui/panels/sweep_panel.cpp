#include "panels/sweep_panel.h"

#include <qcustomplot.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "models/problem_model.h"
#include "models/units.h"
#include "plots/axis_look.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr double kManyDepths = 2000;  // beyond, every second power of two is labelled

}  // namespace

SweepPanel::SweepPanel(QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), verdict_(new QLabel(this)), button_(new QPushButton(this)) {
  setObjectName("sweepPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 8, 4);
  row->addWidget(verdict_, 1);
  row->addWidget(button_);
  verdict_->setProperty("role", "secondary");
  verdict_->setWordWrap(true);
  verdict_->setObjectName("sweepVerdict");
  button_->setObjectName("sweepButton");
  button_->setEnabled(false);
  column->addLayout(row);
  plot_->setObjectName("sweepPlot");
  plot_->setMinimumHeight(120);
  column->addWidget(plot_, 1);
  curve_ = plot_->addGraph();
  mark_ = plot_->addGraph();
  plot_->xAxis->setScaleType(QCPAxis::stLogarithmic);
  plot_->axisRect()->setAutoMargins(QCP::msLeft | QCP::msBottom | QCP::msTop | QCP::msRight);
  connect(button_, &QPushButton::clicked, this, &SweepPanel::compute);
  connect(plot_, &QCustomPlot::mousePress, this,
          [this](QMouseEvent* event) { pick(plot_->xAxis->pixelToCoord(event->position().x())); });
  connect(&service_, &TuneService::swept, this, [this](const LookaheadSweep& sweep) {
    sweep_ = sweep;
    draw();
    showVerdict();
  });
  connect(&service_, &TuneService::progressed, this,
          [this](double fraction) { verdict_->setText(tr("planning… %1 %").arg(static_cast<int>(fraction * 100))); });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { verdict_->setText(message_text(error.code, error.message)); });
  connect(&service_, &TuneService::finished, this, [this] {
    button_->setEnabled(timeline_ != nullptr);
    emit computed();
  });
  setTheme(theme_);
  retranslate();
}

void SweepPanel::showPlans(const Planned& plan, const Planned&) {
  if (plan.timeline == timeline_) return;
  // A move of the depth alone leaves the curve as it is.
  const auto key = [](const Timeline& t) { return t.outcome()->job->program; };
  const bool other_program = !plan.timeline || !timeline_ || key(*plan.timeline) != key(*timeline_);
  timeline_ = plan.timeline;
  button_->setEnabled(timeline_ != nullptr);
  if (!other_program) return;
  service_.cancel();
  sweep_ = {};
  draw();
  showVerdict();
}

void SweepPanel::compute() {
  if (!timeline_) return;
  button_->setEnabled(false);
  service_.sweep(timeline_->outcome()->job);
}

double SweepPanel::positionOf(std::size_t index) const {
  const auto& points = sweep_.points;
  if (points[index].lookahead) return static_cast<double>(*points[index].lookahead);
  return index == 0 ? 1.0 : 2.0 * positionOf(index - 1);  // "all" stands at the right end
}

void SweepPanel::draw() {
  const auto& points = sweep_.points;
  QVector<double> x, y;
  for (std::size_t i = 0; i < points.size(); ++i) {
    x << positionOf(i);
    y << points[i].cycle_time;
  }
  curve_->setData(x, y, true);
  mark_->setData(QVector<double>(), QVector<double>());
  if (!points.empty()) {
    mark_->setData({x[static_cast<qsizetype>(sweep_.knee)]}, {y[static_cast<qsizetype>(sweep_.knee)]});
    drawAxes(x, y);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void SweepPanel::drawAxes(const QVector<double>& x, const QVector<double>& y) {
  const double end = x.back();
  QSharedPointer<QCPAxisTickerText> ticks(new QCPAxisTickerText);
  const double step = end > kManyDepths ? 4 : 2;
  for (double depth = 1; depth < end / 2; depth *= step) ticks->addTick(depth, QString::number(depth));
  ticks->addTick(end, tr("all"));
  plot_->xAxis->setTicker(ticks);
  plot_->xAxis->setRange(0.9, end * 1.15);
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const double margin = std::max((*high - *low) * 0.08, *high * 0.005);
  plot_->yAxis->setRange(std::max(0.0, *low - margin), *high + margin);
}

void SweepPanel::showVerdict() {
  if (sweep_.points.empty()) return verdict_->setText(tr("Cycle time over look-ahead depth"));
  const SweepPoint& knee = sweep_.points[sweep_.knee];
  const QString time = duration_text(knee.cycle_time);
  verdict_->setText(knee.lookahead ? tr("N = %1 comes within 0.5 % of all: %2").arg(*knee.lookahead).arg(time)
                                   : tr("Only the whole program will do: %1").arg(time));
}

void SweepPanel::pick(double x) {
  if (sweep_.points.empty() || x <= 0) return;
  std::size_t best = 0;
  for (std::size_t i = 0; i < sweep_.points.size(); ++i) {
    if (std::abs(std::log(positionOf(i) / x)) < std::abs(std::log(positionOf(best) / x))) best = i;
  }
  emit depthRequested(sweep_.points[best].lookahead);
}

void SweepPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  plot_->setBackground(theme.surface);
  for (auto* axis : {plot_->xAxis, plot_->yAxis}) dressAxis(*axis, theme, font());
  curve_->setPen(QPen(theme.accent, 1.5));
  curve_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, theme.accent, theme.accent, 4));
  mark_->setLineStyle(QCPGraph::lsNone);
  mark_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(theme.plan_b, 2), Qt::NoBrush, 12));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void SweepPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    draw();
  }
  QWidget::changeEvent(event);
}

void SweepPanel::retranslate() {
  button_->setText(tr("Sweep"));
  name_control(button_, tr("Plan with every look-ahead depth"));
  name_control(plot_, tr("Cycle time over look-ahead depth"), tr("Click on a point to take its depth"));
  plot_->xAxis->setLabel(tr("look-ahead  blocks"));
  plot_->yAxis->setLabel(tr("cycle time  s"));
  showVerdict();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace toolpace::ui
