#pragma once
/// How long the controller that is chosen takes, why, and what each of its settings would give.

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include "drawing/plan_view.h"
#include "jobs/tune_service.h"
#include "panels/limit_bar.h"
#include "panels/supply_fields.h"
#include "theme/theme.h"

namespace toolpace::ui {

class FormGrid;

class ControllerPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit ControllerPanel(QWidget* parent = nullptr);

  void showController(const ControllerView& view) override;
  void setTheme(const Theme& theme) override;
  void compute();  ///< the list of what each setting would give
  bool isComputing() const { return service_.isRunning(); }

 signals:
  void computed();
  /// Somebody wants this value, in the parameter's unit.
  void settingWanted(const QString& key, double value);
  void supplyWanted(const toolpace::PredictOptions& supply);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void stop();
  void showSupply();
  void showVerdict();
  void showLimits();
  void showRows();
  void showHint();
  void takeRow(int row);
  void retranslate();

  TuneService service_;
  QLabel *verdict_, *hint_, *baud_label_, *block_time_label_;
  SupplyFields* supply_;
  FormGrid* grid_;
  LimitBar* bar_;
  QTableWidget *limits_, *rows_table_;
  QPushButton* button_;
  ControllerView view_;
  std::vector<WhatIf> rows_;
  bool has_rows_ = false;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
