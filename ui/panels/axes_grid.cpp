#include "panels/axes_grid.h"

#include "panels/form_grid.h"
#include "panels/key_range.h"

#include "toolpace/base/axis_unit.h"

namespace toolpace::ui {
namespace {

constexpr std::array<Quantity, AxesGrid::kLimits> kQuantities = {Quantity::speed, Quantity::acceleration,
                                                                 Quantity::jerk};
constexpr std::array<const char*, AxesGrid::kLimits> kIds = {"Speed", "Acceleration", "Jerk"};
constexpr std::array<const char*, AxesGrid::kLimits> kSymbols = {"v", "a", "j"};

/// What the machine file takes.
NumberField::Range range_of(std::size_t axis, int limit) {
  const std::string section = std::string("axes.") + kAxisNames[axis];
  const auto& unit = axis_unit(axis).key;
  switch (limit) {
    case AxesGrid::kSpeed: return range_of_key(section, std::string("max_speed_") + unit[1]);
    case AxesGrid::kAcceleration: return range_of_key(section, std::string("max_acceleration_") + unit[2]);
    default: return range_of_key(section, std::string("max_jerk_") + unit[3]);
  }
}

double limit_of(const AxisLimits& axis, int limit) {
  switch (limit) {
    case AxesGrid::kSpeed: return axis.speed;
    case AxesGrid::kAcceleration: return axis.acceleration;
    default: return axis.jerk;
  }
}

}  // namespace

AxesGrid::AxesGrid(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  rotary_ = new QWidget(this);
  auto* linear = new QWidget(this);
  const auto table = [column](QWidget* holder) {
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    column->addWidget(holder);
    return grid;
  };
  const std::array<QGridLayout*, 2> grids = {table(linear), table(rotary_)};
  heading_ = new QLabel(this);
  heading_->setProperty("role", "heading");
  grids[0]->addWidget(heading_, 0, 0);
  for (int limit = 0; limit < kLimits; ++limit) {
    const auto i = static_cast<std::size_t>(limit);
    heads_[i] = secondary_label({}, this);
    rotary_heads_[i] = secondary_label({}, this);
    for (auto* head : {heads_[i], rotary_heads_[i]}) head->setAlignment(Qt::AlignRight);
    grids[0]->addWidget(heads_[i], 0, limit + 1);
    grids[1]->addWidget(rotary_heads_[i], 0, limit + 1);
    for (auto* grid : grids) grid->setColumnStretch(limit + 1, 1);
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const int row = static_cast<int>(axis % 3) + 1;
    QGridLayout* grid = grids[is_rotary(axis) ? 1 : 0];
    names_[axis] = new QLabel(QString(QLatin1Char(kAxisNames[axis])), this);
    grid->addWidget(names_[axis], row, 0);
    for (int limit = 0; limit < kLimits; ++limit) {
      const auto i = static_cast<std::size_t>(limit);
      const QString name = QString("axis%1%2").arg(QLatin1Char(kAxisNames[axis])).arg(kIds[i]);
      const Quantity quantity = is_rotary(axis) ? rotary(kQuantities[i]) : kQuantities[i];
      auto* field = new NumberField(name, {}, quantity, range_of(axis, limit), this);
      fields_[axis][i] = field;
      grid->addWidget(field, row, limit + 1);
      connect(field, &NumberField::edited, this,
              [this, axis, limit](double value) { emit edited(static_cast<int>(axis), limit, value); });
      connect(field, &NumberField::gestureStarted, this, &AxesGrid::gestureStarted);
      connect(field, &NumberField::gestureFinished, this, &AxesGrid::gestureFinished);
    }
  }
  retranslate();
  setRotaryAxes({});
}

void AxesGrid::setMachine(const Machine& machine) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    for (int limit = 0; limit < kLimits; ++limit) {
      fields_[axis][static_cast<std::size_t>(limit)]->setValue(limit_of(machine.axes[axis], limit));
    }
  }
}

void AxesGrid::setRotaryAxes(const std::array<bool, 3>& shown) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    names_[3 + i]->setVisible(shown[i]);
    for (auto* field : fields_[3 + i]) field->setVisible(shown[i]);
  }
  rotary_->setVisible(shown[0] || shown[1] || shown[2]);
}

void AxesGrid::setUnits(Units unit) {
  unit_ = unit;
  for (auto& row : fields_) {
    for (auto* field : row) field->setUnits(unit);
  }
  show_units();
}

void AxesGrid::show_units() {
  for (std::size_t i = 0; i < kLimits; ++i) {
    const QString symbol = kSymbols[i];
    heads_[i]->setText(symbol + "  " + display_unit(kQuantities[i], unit_).text);
    rotary_heads_[i]->setText(symbol + "  " + display_unit(rotary(kQuantities[i]), unit_).text);
  }
}

void AxesGrid::retranslate() {
  heading_->setText(tr("Axis"));
  const std::array<QString, kLimits> titles = {tr("top speed"), tr("acceleration limit"), tr("jerk limit")};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    for (std::size_t i = 0; i < kLimits; ++i) {
      const QString name = tr("Axis %1, %2").arg(QLatin1Char(kAxisNames[axis])).arg(titles[i]);
      fields_[axis][i]->setAccessibleName(name);
      fields_[axis][i]->setToolTip(tr("%1; empty = no limit").arg(name));
    }
  }
  show_units();
}

}  // namespace toolpace::ui
