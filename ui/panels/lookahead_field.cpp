#include "panels/lookahead_field.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "theme/control_name.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace::ui {
namespace {

constexpr int kSteps = 1000;  // of the slider; the last one is "all"
constexpr double kDeepest = kDeepestLookahead;

}  // namespace

LookaheadField::LookaheadField(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      field_(new NumberField("lookaheadEdit", {}, Quantity::time, {1, kDeepest, true, true}, this)),
      all_(new QToolButton(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(slider_, 1);
  row->addWidget(field_);
  row->addWidget(all_);
  setObjectName("lookaheadField");
  slider_->setObjectName("lookaheadSlider");
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 20);
  field_->setUnit({1.0, {}});
  field_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  all_->setObjectName("lookaheadAll");
  all_->setCheckable(true);
  setFocusProxy(slider_);

  connect(slider_, &QSlider::sliderPressed, this, &LookaheadField::gestureStarted);
  connect(slider_, &QSlider::sliderReleased, this, &LookaheadField::gestureFinished);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) { take(depth_at(position)); });
  connect(field_, &NumberField::gestureStarted, this, &LookaheadField::gestureStarted);
  connect(field_, &NumberField::gestureFinished, this, &LookaheadField::gestureFinished);
  connect(field_, &NumberField::edited, this, [this](double depth) {
    take(std::isinf(depth) ? std::optional<std::size_t>() : static_cast<std::size_t>(depth));
  });
  connect(all_, &QToolButton::clicked, this,
          [this](bool on) { take(on ? std::optional<std::size_t>() : std::optional(before_all_)); });
  retranslate();
  show_value();
}

void LookaheadField::retranslate() {
  all_->setText(tr("all"));
  name_control(all_, tr("Look ahead over the whole program"));
  slider_->setToolTip(tr("Look-ahead depth in blocks, logarithmic; the right end is the whole program"));
  slider_->setAccessibleName(tr("Look-ahead depth"));
  field_->setAccessibleName(tr("Look-ahead depth in blocks"));
  field_->setToolTip(tr("Look-ahead depth in blocks; 1 stops at every node"));
}

void LookaheadField::setValue(std::optional<std::size_t> depth) {
  depth_ = depth;
  if (depth) before_all_ = *depth;
  show_value();
}

void LookaheadField::setBlockCount(std::size_t blocks) {
  most_ = std::max<std::size_t>(blocks, 2);
  show_value();
}

int LookaheadField::position_of(std::optional<std::size_t> depth) const {
  if (!depth) return kSteps;
  const double share = std::log(static_cast<double>(*depth)) / std::log(static_cast<double>(most_));
  return std::clamp(static_cast<int>(std::lround(share * (kSteps - 1))), 0, kSteps - 1);
}

std::optional<std::size_t> LookaheadField::depth_at(int position) const {
  if (position >= kSteps) return std::nullopt;
  const double share = static_cast<double>(position) / (kSteps - 1);
  return static_cast<std::size_t>(std::lround(std::exp(share * std::log(static_cast<double>(most_)))));
}

void LookaheadField::take(std::optional<std::size_t> depth) {
  if (depth == depth_) return;
  depth_ = depth;
  if (depth) before_all_ = *depth;
  show_value();
  emit edited(depth_);
}

void LookaheadField::show_value() {
  const QSignalBlocker quiet(slider_);
  if (!slider_->isSliderDown()) slider_->setValue(position_of(depth_));
  field_->setValue(depth_ ? static_cast<double>(*depth_) : std::numeric_limits<double>::infinity());
  all_->setChecked(!depth_);
}

}  // namespace toolpace::ui
