#pragma once
/// The axes' limits as a table of exact entries: a row an axis, columns speed, acceleration, jerk.

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>
#include <array>

#include "panels/number_field.h"
#include "toolpace/limits/machine.h"

namespace toolpace::ui {

class AxesGrid : public QWidget {
  Q_OBJECT

 public:
  enum Limit { kSpeed, kAcceleration, kJerk, kLimits };

  explicit AxesGrid(QWidget* parent = nullptr);

  void setMachine(const Machine& machine);
  /// Which of A, B, C have a row; X, Y, Z always have.
  void setRotaryAxes(const std::array<bool, 3>& shown);
  void setUnits(Units unit);
  void retranslate();

 signals:
  void edited(int axis, int limit, double core_value);
  void gestureStarted();
  void gestureFinished();

 private:
  void show_units();

  std::array<std::array<NumberField*, kLimits>, kAxisCount> fields_ = {};
  std::array<QLabel*, kAxisCount> names_ = {};
  QLabel* heading_;
  std::array<QLabel*, kLimits> heads_ = {};
  std::array<QLabel*, kLimits> rotary_heads_ = {};
  QWidget* rotary_;
  Units unit_;
};

}  // namespace toolpace::ui
