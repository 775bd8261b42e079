#pragma once
/// Where the time goes, by what holds the speed down, and what raising each limit would save, by planning it.

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <memory>
#include <vector>

#include "drawing/plan_view.h"
#include "jobs/tune_service.h"
#include "models/timeline.h"
#include "theme/theme.h"

namespace toolpace::ui {

class WhatIfPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit WhatIfPanel(QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setTheme(const Theme& theme) override;
  void compute();
  bool isComputing() const { return service_.isRunning(); }

 signals:
  void computed();

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void showCauses();
  void showSavings(const std::vector<Saving>& savings);
  void retranslate();

  TuneService service_;
  QTableWidget *causes_, *levers_table_;
  QLabel* hint_;
  QPushButton* button_;
  std::shared_ptr<const Timeline> timeline_;
  Theme theme_ = light_theme();
  bool stale_ = false;  // the causes are not yet those of the timeline
};

}  // namespace toolpace::ui
