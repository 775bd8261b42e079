#pragma once
/// The page "Drives": the model of each axis' drive, with the contour error that comes of it.

#include <QGridLayout>
#include <QLabel>
#include <QWidget>
#include <array>

#include "drawing/plan_view.h"
#include "models/tuning_model.h"
#include "panels/calm_panel.h"
#include "panels/number_field.h"

namespace toolpace::ui {

class DrivesPage : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit DrivesPage(TuningModel& model, QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setUnits(Units unit) override;
  /// Which of A, B, C have a column; X, Y, Z always have.
  void setRotaryAxes(const std::array<bool, 3>& shown);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  static constexpr std::size_t kParameters = 8;

  NumberField* makeField(std::size_t parameter, std::size_t axis);
  void showValues();
  void showErrors();
  void retranslate();

  TuningModel& model_;
  QGridLayout* grid_;
  std::array<QLabel*, kParameters> titles_ = {}, units_ = {};
  std::array<QLabel*, kAxisCount> heads_ = {};
  std::array<std::array<NumberField*, kAxisCount>, kParameters> fields_ = {};
  QLabel* errors_;
  CalmPanel* calm_;
  Planned plan_;
  Units unit_;
};

}  // namespace toolpace::ui
