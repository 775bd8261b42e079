#pragma once
/// A machine that shakes: its modes, the shaper in use, and what would keep it calm, with what that costs.

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <memory>

#include "jobs/tune_service.h"
#include "models/tuning_model.h"
#include "panels/number_field.h"
#include "theme/theme.h"
#include "toolpace/tune/vibration_advice.h"

namespace toolpace::ui {

/// A choice that is taken is an undo step of the model.
class CalmPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CalmPanel(TuningModel& model, QWidget* parent = nullptr);

  /// Whose program is planned; null = none.
  void setJob(std::shared_ptr<const Job> job);
  void advise();
  bool isAdvising() const { return service_.isRunning(); }
  const std::optional<VibrationAdvice>& advice() const { return advice_; }
  void setUnits(Units units);
  void retranslate();

 signals:
  void advised();

 private:
  void connectParts();
  std::shared_ptr<const Job> present() const;
  void showValues();
  void fill();
  void showState();
  void take(int row);

  TuningModel& model_;
  TuneService service_;
  QLabel *title_, *modes_, *shaper_label_, *limit_label_, *limit_unit_, *hint_;
  QComboBox* shaper_;
  NumberField* limit_;
  QPushButton* button_;
  QTableWidget* table_;
  std::shared_ptr<const Job> job_, asked_;  // of the plan that is shown; that advice was asked for
  std::optional<VibrationAdvice> advice_;
  QString trouble_;
  Units units_;
};

}  // namespace toolpace::ui
