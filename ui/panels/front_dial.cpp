#include "panels/front_dial.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "panels/form_grid.h"
#include "theme/control_name.h"

namespace toolpace::ui {

QString objectives_text(const Objectives& o, Units units) {
  const DisplayUnit unit = error_unit(units);
  const auto error = [&](double length) { return number_text(length * unit.factor, 4) + " " + unit.text; };
  QString text = duration_text(o.cycle_time) + " · " + error(o.contour);
  if (o.vibration) text += " · " + FrontDial::tr("vibration %1").arg(error(*o.vibration));
  return text;
}

FrontDial::FrontDial(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      rough_(secondary_label({}, this)),
      finish_(secondary_label({}, this)),
      fine_(secondary_label({}, this)),
      numbers_(new QLabel(this)),
      best_(new QPushButton(this)),
      knee_(new QPushButton(this)) {
  setObjectName("frontDial");
  slider_->setObjectName("frontSlider");
  numbers_->setObjectName("frontNumbers");
  best_->setObjectName("frontBest");
  knee_->setObjectName("frontKnee");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(0);
  grid->addWidget(rough_, 0, 0, Qt::AlignLeft);
  grid->addWidget(finish_, 0, 1, Qt::AlignHCenter);
  grid->addWidget(fine_, 0, 2, Qt::AlignRight);
  grid->addWidget(slider_, 1, 0, 1, 3);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(numbers_, 1);
  row->addWidget(knee_);
  row->addWidget(best_);
  grid->addLayout(row, 2, 0, 1, 3);
  connect(slider_, &QSlider::sliderPressed, this, &FrontDial::gestureStarted);
  connect(slider_, &QSlider::sliderReleased, this, &FrontDial::gestureFinished);
  connect(slider_, &QSlider::valueChanged, this, [this](int at) { emit chosen(static_cast<std::size_t>(at)); });
  // A key that leads to where the slider stands already, while other settings are in use.
  connect(slider_, &QSlider::actionTriggered, this, [this] {
    if (!used_ && slider_->sliderPosition() == slider_->value())
      emit chosen(static_cast<std::size_t>(slider_->value()));
  });
  connect(best_, &QPushButton::clicked, this, [this] { emit chosen(*tuning_->best); });
  connect(knee_, &QPushButton::clicked, this, [this] { emit chosen(tuning_->knee); });
  setTuning(nullptr, false);
  retranslate();
}

void FrontDial::setTuning(std::shared_ptr<const toolpace::TuneResult> tuning, bool stale) {
  tuning_ = std::move(tuning);
  const bool turns = tuning_ && !stale;
  const QSignalBlocker quiet(slider_);
  slider_->setRange(0, tuning_ ? static_cast<int>(tuning_->front.size()) - 1 : 0);
  slider_->setPageStep(std::max(1, slider_->maximum() / 10));
  slider_->setEnabled(turns && slider_->maximum() > 0);
  knee_->setEnabled(turns);
  best_->setEnabled(turns && tuning_->best);
  showNumbers();
}

void FrontDial::setUsed(std::optional<std::size_t> index) {
  used_ = index;
  const QSignalBlocker quiet(slider_);
  if (index) slider_->setValue(static_cast<int>(*index));
  if (!index && tuning_) {  // beside those that take no longer
    const auto& front = tuning_->front;
    const auto slower = std::find_if(front.begin(), front.end(), [this](const Tuned& t) {
      return t.objectives.cycle_time > tuning_->present.objectives.cycle_time;
    });
    slider_->setValue(std::max(0, static_cast<int>(slower - front.begin()) - 1));
  }
  showNumbers();
}

void FrontDial::showNumbers() {
  if (!tuning_) return numbers_->clear();
  numbers_->setText(objectives_text(used_ ? tuning_->front[*used_].objectives : tuning_->present.objectives, units_));
}

void FrontDial::setUnits(Units units) {
  units_ = units;
  showNumbers();
}

void FrontDial::retranslate() {
  rough_->setText(tr("rough"));
  finish_->setText(tr("finish"));
  fine_->setText(tr("fine"));
  name_control(slider_, tr("From rough to fine"), tr("The best settings from the fastest to the most accurate"));
  name_control(numbers_, tr("Cycle time and contour error of the settings in use"));
  knee_->setText(tr("Balanced"));
  name_control(knee_, knee_->text(), tr("Where a little more accuracy begins to cost much time"));
  best_->setText(tr("Fastest within the limit"));
  name_control(best_, best_->text(), tr("The fastest settings whose contour error is within the limit"));
  showNumbers();
}

}  // namespace toolpace::ui
