#pragma once
/// What each NC line loses against its programmed feed, the worst first.

#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QWidget>

#include "drawing/plan_view.h"
#include "models/loss_model.h"

namespace toolpace::ui {

class LossPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit LossPanel(QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setUnits(Units unit) override;

 signals:
  void lineRequested(int line);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();
  void showTotal();

  LossModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QLabel* total_;
  std::shared_ptr<const Timeline> timeline_, shown_;  // the second stands in the table
};

}  // namespace toolpace::ui
