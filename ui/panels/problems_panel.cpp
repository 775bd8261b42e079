#include "panels/problems_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "panels/problem_delegate.h"
#include "panels/results_panel.h"

namespace toolpace::ui {
namespace {

constexpr int kPlaceWidth = 56;   // room for its title
constexpr int kMostButtons = 50;  // beside problems that the window can do something about

}  // namespace

ProblemsPanel::ProblemsPanel(QWidget* parent)
    : QWidget(parent), model_(new ProblemModel(this)), table_(new QTableView(this)), empty_(new QLabel(this)) {
  setObjectName("problemsPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  empty_->setProperty("role", "secondary");
  empty_->setContentsMargins(8, 8, 8, 8);
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  column->addWidget(empty_);
  column->addWidget(table_, 1);
  table_->setObjectName("problemTable");
  table_->setModel(model_);
  style_table(table_);
  delegate_ = new ProblemDelegate(table_);
  table_->setItemDelegateForColumn(ProblemModel::kMessage, delegate_);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setMinimumSectionSize(kPlaceWidth);
  table_->horizontalHeader()->setSectionResizeMode(ProblemModel::kPlace, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(ProblemModel::kMessage, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(ProblemModel::kAction, QHeaderView::Fixed);
  // Rows are as high as their text at the width that there is, also where that is known only once the tab is seen.
  connect(table_->horizontalHeader(), &QHeaderView::sectionResized, table_, &QTableView::resizeRowsToContents,
          Qt::QueuedConnection);
  const auto go = [this](const QModelIndex& index) {
    const auto line = model_->at(index.row()).where.line;
    if (line > 0) emit lineRequested(static_cast<int>(line));
  };
  connect(table_, &QTableView::clicked, this, go);
  connect(table_, &QTableView::activated, this, go);
  showState();
}

void ProblemsPanel::setProblems(const Diagnostics& problems) {
  model_->setProblems(problems);
  showButtons();
  showState();
}

/// A new set of problems has taken the buttons of the last one away.
void ProblemsPanel::showButtons() {
  int buttons = 0, widest = 0;
  for (int row = 0; row < model_->rowCount() && buttons < kMostButtons; ++row) {
    const ProblemAction action = action_for(model_->at(row).code);
    if (action == ProblemAction::none) continue;
    auto* cell = new QWidget(table_);
    auto* column = new QVBoxLayout(cell);
    column->setContentsMargins(0, ProblemDelegate::kAbove, 0, ProblemDelegate::kAbove);
    auto* button = new QPushButton(action_text(action), cell);
    column->addWidget(button, 0, Qt::AlignTop);
    button->setObjectName(QString("problemAction%1").arg(row));
    button->setAccessibleName(action_text(action));
    connect(button, &QPushButton::clicked, this, [this, action] { emit actionRequested(action); });
    button->ensurePolished();  // it is as wide as its style makes it
    widest = std::max(widest, cell->sizeHint().width());
    table_->setIndexWidget(model_->index(row, ProblemModel::kAction), cell);
    ++buttons;
  }
  table_->setColumnHidden(ProblemModel::kAction, buttons == 0);
  if (buttons > 0) table_->setColumnWidth(ProblemModel::kAction, widest + 2 * ProblemDelegate::kSide);
}

void ProblemsPanel::setTheme(const Theme& theme) {
  model_->setTheme(theme);
  showButtons();
  delegate_->setTheme(theme);
}

void ProblemsPanel::showState() {
  empty_->setText(tr("No errors, no warnings"));
  empty_->setVisible(model_->rowCount() == 0);
  table_->setVisible(model_->rowCount() > 0);
  table_->setAccessibleName(tr("Errors and warnings"));
}

void ProblemsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    setProblems(Diagnostics(model_->problems()));
  }
  QWidget::changeEvent(event);
}

}  // namespace toolpace::ui
