#pragma once
/// List of errors and warnings; a click goes to the line.

#include <QLabel>
#include <QTableView>
#include <QWidget>

#include "models/problem_action.h"
#include "models/problem_model.h"

namespace toolpace::ui {

class ProblemDelegate;

class ProblemsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProblemsPanel(QWidget* parent = nullptr);

  void setProblems(const Diagnostics& problems);
  void setTheme(const Theme& theme);

 signals:
  void lineRequested(int line);
  void actionRequested(toolpace::ui::ProblemAction action);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showState();
  void showButtons();

  ProblemModel* model_;
  QTableView* table_;
  ProblemDelegate* delegate_;
  QLabel* empty_;
};

}  // namespace toolpace::ui
