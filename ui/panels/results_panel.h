#pragma once
/// Figures of A and B side by side, with pin and swap.

#include <QLabel>
#include <QPushButton>
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
  void showController(const ControllerView& view) override;
  void setUnits(Units unit) override;
  void setTheme(const Theme& theme) override;
  void showProofState(ProofService::State state);

  QString text() const;  ///< all figures that are seen, columns separated by tabs

 signals:
  void menuRequested(const QPoint& global);
  void checkRequested();
  void stopCheckRequested();
  void pinRequested();
  void unpinRequested();
  void swapRequested();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void retranslate();
  void showHeadline();
  void showVerdict();
  void buildCheckBar();
  void showCheckBar();
  void fitRows();

  ResultModel* model_;
  QTableView* table_;
  UnitDelegate* titles_;
  QLabel *cycle_, *versus_, *controller_;
  QToolButton *pin_, *swap_, *unpin_;
  QWidget* check_bar_;  ///< asks whether to check what is long
  QLabel* check_text_;
  QPushButton* check_;
  ProofService::State proof_state_ = ProofService::State::idle;
  bool asked_ = false;  ///< for the check that runs
  Planned a_, b_;
  ControllerView controller_view_;
  Theme theme_ = light_theme();
};

/// Dresses a table the way all tables of the workbench look.
void style_table(QTableView* table);

}  // namespace toolpace::ui
