#include "panels/results_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "panels/unit_delegate.h"
#include "theme/icons.h"

namespace toolpace::ui {
namespace {

constexpr int kRowHeight = 20;
constexpr int kLeastColumn = 56;
constexpr double kHeadlineScale = 1.6;

QToolButton* button(const char* name, QWidget* parent) {
  auto* result = new QToolButton(parent);
  result->setObjectName(name);
  result->setIconSize({16, 16});
  return result;
}

}  // namespace

void style_table(QTableView* table) {
  table->setShowGrid(false);
  table->setFrameShape(QFrame::NoFrame);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setWordWrap(false);
  table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table->setTabKeyNavigation(false);
  table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table->verticalHeader()->setMinimumSectionSize(kRowHeight);
  table->horizontalHeader()->setHighlightSections(false);
  table->verticalHeader()->setHighlightSections(false);
  table->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

ResultsPanel::ResultsPanel(QWidget* parent)
    : QWidget(parent),
      model_(new ResultModel(this)),
      table_(new QTableView(this)),
      cycle_(new QLabel(this)),
      versus_(new QLabel(this)),
      pin_(button("pinButton", this)),
      swap_(button("swapButton", this)),
      unpin_(button("unpinButton", this)) {
  setObjectName("resultsPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 0, 8, 0);
  head->setSpacing(4);
  cycle_->setObjectName("cycleTimeLabel");
  QFont font = cycle_->font();
  font.setPointSizeF(font.pointSizeF() * kHeadlineScale);
  cycle_->setFont(font);
  versus_->setObjectName("cycleDeltaLabel");
  head->addWidget(cycle_);
  head->addSpacing(8);
  head->addWidget(versus_, 1);
  for (auto* b : {pin_, swap_, unpin_}) head->addWidget(b);
  column->addLayout(head);
  table_->setObjectName("resultTable");
  table_->setModel(model_);
  style_table(table_);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setMinimumSectionSize(kLeastColumn);
  table_->horizontalHeader()->setSectionResizeMode(ResultModel::kTitle, QHeaderView::Stretch);
  titles_ = new UnitDelegate(table_);
  table_->setItemDelegateForColumn(ResultModel::kTitle, titles_);
  column->addWidget(table_, 1);
  connect(pin_, &QToolButton::clicked, this, &ResultsPanel::pinRequested);
  connect(swap_, &QToolButton::clicked, this, &ResultsPanel::swapRequested);
  connect(unpin_, &QToolButton::clicked, this, &ResultsPanel::unpinRequested);
  setTheme(theme_);
  retranslate();
  showPlans({}, {});
}

void ResultsPanel::showPlans(const Planned& a, const Planned& b) {
  a_ = a;
  b_ = b;
  model_->setPlans(a, b);
  pin_->setEnabled(static_cast<bool>(a_));
  swap_->setEnabled(a_ && b_);
  unpin_->setEnabled(static_cast<bool>(b_));
  for (int column : {ResultModel::kPlanB, ResultModel::kDelta}) table_->setColumnHidden(column, !b_);
  table_->horizontalHeader()->setVisible(static_cast<bool>(b_));  // one column explains itself
  for (int row = 0; row < model_->rowCount(); ++row) table_->setRowHidden(row, model_->isIdle(row));
  showHeadline();
  fitRows();
}

/// Where there is little room, rows come closer before anything has to be scrolled for.
void ResultsPanel::fitRows() {
  auto& rows = *table_->verticalHeader();
  // Rows that were hidden while the height changed keep the old one.
  const auto make_even = [&] {
    for (int row = 0; row < rows.count(); ++row) {
      if (!table_->isRowHidden(row)) rows.resizeSection(row, rows.defaultSectionSize());
    }
  };
  if (rows.defaultSectionSize() > kRowHeight) return make_even();  // for fingers
  int shown = 0;
  for (int row = 0; row < model_->rowCount(); ++row) shown += table_->isRowHidden(row) ? 0 : 1;
  const int least = std::min(table_->fontMetrics().height() + 1, kRowHeight);
  const int fair = table_->viewport()->height() / std::max(shown, 1);
  rows.setMinimumSectionSize(least);
  rows.setDefaultSectionSize(std::clamp(fair, least, kRowHeight));
  make_even();
}

void ResultsPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitRows();
}

void ResultsPanel::showHeadline() {
  cycle_->setText(a_ ? duration_text(a_.timeline->duration()) : QString("–"));
  versus_->clear();
  if (!a_ || !b_ || b_.timeline->duration() <= 0) return;
  const double delta = a_.timeline->duration() - b_.timeline->duration();
  const QString role = delta < 0 ? "good" : delta > 0 ? "error" : "secondary";
  versus_->setProperty("role", role);
  versus_->setStyleSheet({});  // look the role up again
  versus_->setText(QString("%1%2 s").arg(delta < 0 ? "−" : "+").arg(std::abs(delta), 0, 'f', 3));
}

void ResultsPanel::setLengthUnit(LengthUnit unit) { model_->setUnit(unit); }

void ResultsPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  model_->setTheme(theme);
  titles_->setTheme(theme);
  pin_->setIcon(icon("pin", theme));
  swap_->setIcon(icon("swap", theme));
  unpin_->setIcon(icon("cancel", theme));
}

void ResultsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ResultsPanel::retranslate() {
  model_->retranslate();
  table_->setAccessibleName(tr("Results of plans A and B"));
  const auto name = [](QToolButton* b, const QString& text) {
    b->setToolTip(text);
    b->setAccessibleName(text);
  };
  name(pin_, tr("Pin this plan as B"));
  name(swap_, tr("Swap A and B"));
  name(unpin_, tr("Let go of B"));
  cycle_->setToolTip(tr("Cycle time of plan A"));
  cycle_->setAccessibleName(tr("Cycle time of plan A"));
  showHeadline();
}

}  // namespace toolpace::ui
