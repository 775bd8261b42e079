#pragma once
/// Figures of A and B side by side, with pin and swap.

#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QWidget>

#include "drawing/plan_view.h"
#include "panels/result_model.h"

namespace toolpace::ui {

class UnitDelegate;

class ResultsPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit ResultsPanel(QWidget* parent = nullptr);

  void showPlans(const Planned& a, const Planned& b) override;
  void setLengthUnit(LengthUnit unit) override;
  void setTheme(const Theme& theme) override;

 signals:
  void pinRequested();
  void unpinRequested();
  void swapRequested();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void retranslate();
  void showHeadline();
  void fitRows();

  ResultModel* model_;
  QTableView* table_;
  UnitDelegate* titles_;
  QLabel *cycle_, *versus_;
  QToolButton *pin_, *swap_, *unpin_;
  Planned a_, b_;
  Theme theme_ = light_theme();
};

/// Dresses a table the way all tables of the workbench look.
void style_table(QTableView* table);

}  // namespace toolpace::ui
