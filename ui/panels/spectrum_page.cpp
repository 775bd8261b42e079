#include "panels/spectrum_page.h"

#include <qcustomplot.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "models/problem_model.h"
#include "plots/axis_look.h"
#include "theme/control_name.h"
#include "theme/line_key.h"

namespace toolpace::ui {
namespace {

constexpr int kDelayMs = 150;  // while a border of the visible time is dragged
enum Range { kWhole, kVisible };
constexpr double kHead = 1.06;  // of the largest value, so that it does not touch the frame

QCustomPlot* new_plot(const char* name, QWidget* parent) {
  auto* plot = new QCustomPlot(parent);
  plot->setObjectName(name);
  plot->setMinimumHeight(90);
  plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plot->axisRect()->setRangeDrag(Qt::Horizontal);
  plot->axisRect()->setRangeZoom(Qt::Horizontal);
  plot->setPlottingHints(QCP::phFastPolylines);
  return plot;
}

}  // namespace

SpectrumPage::SpectrumPage(QWidget* parent)
    : QWidget(parent),
      axis_(new QComboBox(this)),
      range_(new QComboBox(this)),
      verdict_(new QLabel(this)),
      spectrum_(new_plot("spectrumPlot", this)),
      histogram_(new_plot("histogramPlot", this)),
      key_(new LineKey("histogramKey", this)) {
  setObjectName("spectrumPage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  axis_->setObjectName("spectrumAxis");
  range_->setObjectName("spectrumRange");
  verdict_->setObjectName("spectrumVerdict");
  verdict_->setProperty("role", "secondary");
  verdict_->setWordWrap(true);
  for (auto* box : {axis_, range_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(box, &QComboBox::currentIndexChanged, this, &SpectrumPage::ask);
  }
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  head->addWidget(axis_);
  head->addWidget(range_);
  head->addWidget(verdict_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  column->addLayout(head);
  column->addWidget(spectrum_, 1);
  column->addWidget(histogram_, 1);
  column->addWidget(key_);
  delay_.setSingleShot(true);
  delay_.setInterval(kDelayMs);
  connect(&delay_, &QTimer::timeout, this, &SpectrumPage::ask);
  connect(&service_, &AnalysisService::analysed, this, [this](const std::shared_ptr<const MotionAnalysis>& analysis) {
    analysis_ = analysis;
    draw();
  });
  connect(&service_, &AnalysisService::failed, this, [this](const Error& error) {
    analysis_.reset();
    draw();
    verdict_->setText(error.code == "too-few-setpoints" ? tr("The time is too short for a spectrum")
                                                        : message_text(error.code, error.message));
  });
  buildPlots();
  retranslate();
  setRotaryAxes({});
}

void SpectrumPage::buildPlots() {
  curve_ = spectrum_->addGraph();
  spectrum_->xAxis->setScaleType(QCPAxis::stLogarithmic);
  spectrum_->xAxis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  for (std::size_t cause = 0; cause < kCauseCount; ++cause) {
    auto* bars = new QCPBars(histogram_->xAxis, histogram_->yAxis);
    bars->setWidthType(QCPBars::wtPlotCoords);
    bars->setPen(Qt::NoPen);
    bars->setAntialiased(false);
    bars->setStackingGap(0);
    if (!bars_.empty()) bars->moveAbove(bars_.back());
    bars_.push_back(bars);
  }
}

std::optional<std::size_t> SpectrumPage::axis() const {
  const int chosen = axis_->currentData().toInt();
  return chosen < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(chosen));
}

DisplayUnit SpectrumPage::amplitudeUnit() const {
  const bool turns = axis() && is_rotary(*axis());
  return display_unit(turns ? Quantity::angular_acceleration : Quantity::acceleration, unit_);
}

void SpectrumPage::showPlans(const Planned& plan, const Planned&) {
  const bool another = plan.timeline != plan_.timeline;
  plan_ = plan;
  if (another) ask();
}

void SpectrumPage::setVisibleTime(double begin, double end) {
  begin_ = begin;
  end_ = end;
  if (range_->currentIndex() == kVisible && isVisible()) delay_.start();
}

void SpectrumPage::setRotaryAxes(const std::array<bool, 3>& shown) {
  if (axis_->count() > 0 && rotary_ == shown) return;
  rotary_ = shown;
  const QVariant before = axis_->currentData();
  const QSignalBlocker quiet(axis_);
  axis_->clear();
  axis_->addItem(tr("along the path"), -1);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!is_rotary(i) || shown[i - 3])
      axis_->addItem(tr("axis %1").arg(QLatin1Char(kAxisNames[i])), static_cast<int>(i));
  }
  axis_->setCurrentIndex(before.isValid() ? std::max(axis_->findData(before), 0) : 1);
}

void SpectrumPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  ask();
}

void SpectrumPage::ask() {
  delay_.stop();
  if (!plan_) {
    service_.cancel();
    analysis_.reset();
    return draw();
  }
  if (!isVisible()) return;
  AnalysisRequest request{plan_.timeline->outcome(), axis(), 0, plan_.timeline->duration()};
  if (range_->currentIndex() == kVisible) {
    request.begin = begin_;
    request.end = end_;
  }
  service_.analyse(request);
}

void SpectrumPage::draw() {
  drawSpectrum();
  drawHistogram();
  showVerdict();
}

void SpectrumPage::drawSpectrum() {
  QVector<QCPGraphData> points;
  double largest = 0;
  if (analysis_) {
    const Spectrum& s = analysis_->spectrum;
    const double factor = amplitudeUnit().factor;
    points.reserve(static_cast<qsizetype>(s.frequency.size()));
    for (std::size_t k = 1; k < s.frequency.size(); ++k) {  // 0 Hz is no place on a logarithmic axis
      points.append({s.frequency[k], s.amplitude[k] * factor});
      largest = std::max(largest, s.amplitude[k] * factor);
    }
    spectrum_->xAxis->setRange(s.resolution, s.frequency.back());
  }
  curve_->data()->set(points, true);
  spectrum_->yAxis->setRange(0, largest > 0 ? kHead * largest : 1.0);
  spectrum_->yAxis->setLabel(tr("amplitude") + "  " + amplitudeUnit().text);
  markModes();
  spectrum_->replot(QCustomPlot::rpQueuedReplot);
}

/// Where the machine file says that the axis shakes.
void SpectrumPage::markModes() {
  std::vector<AxisMode> modes;
  if (plan_ && axis()) modes = modes_of(plan_.timeline->outcome()->job->machine.servo[*axis()]);
  while (modes_.size() < modes.size()) {
    modes_.push_back(new QCPItemStraightLine(spectrum_));
    modes_.back()->setObjectName("mode");
    modes_.back()->setPen(QPen(theme_.warning, 1, Qt::DashLine));
  }
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    modes_[i]->setVisible(i < modes.size());
    if (i >= modes.size()) continue;
    modes_[i]->point1->setCoords(modes[i].frequency, 0);
    modes_[i]->point2->setCoords(modes[i].frequency, 1);
  }
}

void SpectrumPage::drawHistogram() {
  const DisplayUnit unit = display_unit(Quantity::speed, unit_);
  const Ground ground = theme_.dark ? Ground::dark : Ground::light;
  std::vector<KeySample> samples;
  double longest = 0, bin = 1;
  std::size_t count = 0;
  if (analysis_) {
    bin = analysis_->histogram.bin * unit.factor;
    count = analysis_->histogram.time.size();
    for (const auto& row : analysis_->histogram.time) {
      double sum = 0;
      for (const double time : row) sum += time;
      longest = std::max(longest, sum);
    }
  }
  for (std::size_t cause = 0; cause < kCauseCount; ++cause) {
    QVector<double> speeds, times;
    double whole = 0;
    for (std::size_t i = 0; i < count; ++i) {
      speeds << (static_cast<double>(i) + 0.5) * bin;
      times << analysis_->histogram.time[i][cause];
      whole += times.back();
    }
    const QColor colour = cause_colour(static_cast<Cause>(cause), ground);
    bars_[cause]->setData(speeds, times, true);
    bars_[cause]->setWidth(bin);
    bars_[cause]->setBrush(colour);
    if (whole > 0) samples.push_back({cause_title(static_cast<Cause>(cause)), {}, colour});
  }
  key_->setTextColour(theme_.secondary);
  key_->setSamples(std::move(samples));
  histogram_->xAxis->setRange(0, count > 0 ? bin * static_cast<double>(count) : 1.0);
  histogram_->yAxis->setRange(0, longest > 0 ? kHead * longest : 1.0);
  histogram_->xAxis->setLabel(tr("speed") + "  " + unit.text);
  histogram_->replot(QCustomPlot::rpQueuedReplot);
}

void SpectrumPage::showVerdict() {
  if (!analysis_) return verdict_->setText(plan_ ? QString() : tr("Nothing is planned"));
  const Spectrum& s = analysis_->spectrum;
  const auto peak = std::max_element(s.amplitude.begin() + 1, s.amplitude.end());
  const auto at = static_cast<std::size_t>(peak - s.amplitude.begin());
  const DisplayUnit unit = amplitudeUnit();
  verdict_->setText(tr("largest: %1 %2 at %3 Hz · running %4")
                        .arg(number_text(*peak * unit.factor, 3), unit.text, number_text(s.frequency[at], 3),
                             duration_text(analysis_->histogram.total())));
}

void SpectrumPage::setUnits(Units unit) {
  unit_ = unit;
  draw();
}

void SpectrumPage::setTheme(const Theme& theme) {
  theme_ = theme;
  dress();
  draw();
}

void SpectrumPage::dress() {
  for (auto* plot : {spectrum_, histogram_}) {
    plot->setBackground(theme_.surface);
    for (auto* axis : {plot->xAxis, plot->yAxis}) dressAxis(*axis, theme_, font());
  }
  curve_->setPen(QPen(theme_.accent, 1.2));
  for (auto* mode : modes_) mode->setPen(QPen(theme_.warning, 1, Qt::DashLine));
}

void SpectrumPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void SpectrumPage::retranslate() {
  name_control(axis_, tr("Acceleration of"), tr("Whose commanded acceleration: a(t) = d²x/dt²"));
  name_control(range_, tr("Time"), tr("The whole program, or what the plots show of it"));
  const QSignalBlocker quiet(range_);
  const int chosen = std::max(range_->currentIndex(), 0);
  range_->clear();
  range_->addItems({tr("whole program"), tr("visible time")});
  range_->setCurrentIndex(chosen);
  if (axis_->count() > 0) {
    axis_->setItemText(0, tr("along the path"));
    for (int i = 1; i < axis_->count(); ++i) {
      axis_->setItemText(i, tr("axis %1").arg(QLatin1Char(kAxisNames[axis_->itemData(i).toUInt()])));
    }
  }
  name_control(spectrum_, tr("Spectrum of the commanded acceleration"),
               tr("A sine of amplitude A at frequency f stands as A at f; dashed: modes of the axis"));
  name_control(histogram_, tr("Time at each speed"), tr("How long the tool runs at a speed, by what allows no more"));
  name_control(key_, tr("What limits the speed"), tr("Colours of the limits, as in the preview and below the plots"));
  spectrum_->xAxis->setLabel(tr("frequency  Hz"));
  histogram_->yAxis->setLabel(tr("time  s"));
  draw();
}

}  // namespace toolpace::ui
