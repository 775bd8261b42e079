#include "panels/pulse_plot.h"

#include <algorithm>

#include "plots/axis_look.h"

namespace toolpace::ui {
namespace {

QVector<double> vector(const std::vector<double>& values) { return {values.begin(), values.end()}; }

}  // namespace

PulsePlot::PulsePlot(QWidget* parent) : QCustomPlot(parent) {
  setObjectName("stepperPlot");
  setMinimumSize(320, 240);
  plotLayout()->clear();
  auto* margins = new QCPMarginGroup(this);
  int index = 0;
  for (Row* row : {&rate_, &interval_}) {
    row->rect = new QCPAxisRect(this, true);
    row->rect->setupFullAxesBox(true);
    row->rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    plotLayout()->addElement(index++, 0, row->rect);
    row->curve = addGraph(row->rect->axis(QCPAxis::atBottom), row->rect->axis(QCPAxis::atLeft));
  }
  QCPAxis* ticks = interval_.rect->axis(QCPAxis::atLeft);
  ticks->setScaleType(QCPAxis::stLogarithmic);
  ticks->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
}

void PulsePlot::setPreview(const PulsePreview& preview) {
  rate_.curve->setData(vector(preview.pulse), vector(preview.rate), true);
  interval_.curve->setData(vector(preview.pulse), vector(preview.interval), true);
  if (!preview.pulse.empty()) {
    const auto [low, high] = std::minmax_element(preview.interval.begin(), preview.interval.end());
    for (Row* row : {&rate_, &interval_}) {
      row->rect->axis(QCPAxis::atBottom)->setRange(0, preview.pulse.back() + 1);
    }
    rate_.rect->axis(QCPAxis::atLeft)->setRange(0, *std::max_element(preview.rate.begin(), preview.rate.end()) * 1.08);
    interval_.rect->axis(QCPAxis::atLeft)->setRange(*low / 1.5, *high * 1.5);
  }
  replot(rpQueuedReplot);
}

void PulsePlot::setTheme(const Theme& theme) {
  setBackground(theme.surface);
  for (Row* row : {&rate_, &interval_}) {
    for (auto* axis : row->rect->axes()) dressAxis(*axis, theme, font());
    row->curve->setPen(QPen(theme.accent, 1.5));
  }
  replot(rpQueuedReplot);
}

void PulsePlot::retranslate() {
  rate_.rect->axis(QCPAxis::atLeft)->setLabel(tr("step rate  step/s"));
  interval_.rect->axis(QCPAxis::atLeft)->setLabel(tr("interval  ticks"));
  interval_.rect->axis(QCPAxis::atBottom)->setLabel(tr("pulse number"));
  setAccessibleName(tr("Step rate and pulse interval over the pulse number"));
  setToolTip(accessibleName());
  replot(rpQueuedReplot);
}

}  // namespace toolpace::ui
