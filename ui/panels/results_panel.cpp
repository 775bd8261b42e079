#include "panels/results_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "models/controller_names.h"
#include "panels/unit_delegate.h"
#include "theme/control_name.h"
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
      controller_(new QLabel(this)),
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
  controller_->setObjectName("onControllerLabel");
  controller_->setWordWrap(true);
  controller_->setContentsMargins(8, 0, 8, 4);
  controller_->hide();
  column->addWidget(controller_);
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
  buildCheckBar();
  column->addWidget(check_bar_);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& at) { emit menuRequested(table_->viewport()->mapToGlobal(at)); });
  connect(pin_, &QToolButton::clicked, this, &ResultsPanel::pinRequested);
  connect(swap_, &QToolButton::clicked, this, &ResultsPanel::swapRequested);
  connect(unpin_, &QToolButton::clicked, this, &ResultsPanel::unpinRequested);
  setTheme(theme_);
  retranslate();
  showPlans({}, {});
}

void ResultsPanel::buildCheckBar() {
  check_bar_ = new QWidget(this);
  auto* row = new QHBoxLayout(check_bar_);
  row->setContentsMargins(8, 4, 8, 4);
  check_text_ = new QLabel(check_bar_);
  check_text_->setObjectName("checkLabel");
  check_text_->setProperty("role", "secondary");
  check_text_->setWordWrap(true);
  check_ = new QPushButton(check_bar_);
  check_->setObjectName("checkNowButton");
  row->addWidget(check_text_, 1);
  row->addWidget(check_);
  check_bar_->hide();
  connect(check_, &QPushButton::clicked, this, [this] {
    if (proof_state_ == ProofService::State::running) return emit stopCheckRequested();
    asked_ = true;
    emit checkRequested();
  });
}

void ResultsPanel::showProofState(ProofService::State state) {
  proof_state_ = state;
  if (state != ProofService::State::running) asked_ = false;
  model_->setProofState(state);
  showCheckBar();
}

/// Only where a person has to decide; what is checked unasked is soon there.
void ResultsPanel::showCheckBar() {
  using State = ProofService::State;
  const bool runs = proof_state_ == State::running;
  check_text_->setText(runs ? tr("checking…")
                       : proof_state_ == State::too_long
                           ? tr("Not checked: more than %1 setpoints").arg(number_text(kProvenUnasked, 9))
                           : tr("Not checked"));
  check_->setText(runs ? tr("Stop") : tr("Check now"));
  name_control(
      check_, check_->text(),
      runs ? tr("Leave the plan unchecked") : tr("Check every limit at the setpoints, and simulate the drives"));
  check_bar_->setVisible(a_ && (runs ? asked_ : proof_state_ != State::idle));
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
  table_->clearSpans();
  for (int row = 0; row < model_->rowCount(); ++row) {
    table_->setRowHidden(row, model_->isIdle(row));
    if (model_->isSetting(row)) table_->setSpan(row, 0, 1, ResultModel::kColumns);
  }
  showHeadline();
  showCheckBar();
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

QString ResultsPanel::text() const {
  QStringList lines;
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (table_->isRowHidden(row)) continue;
    QStringList cells;
    for (int column = 0; column < model_->columnCount(); ++column) {
      if (!table_->isColumnHidden(column)) cells << model_->index(row, column).data().toString();
    }
    lines << cells.join('\t');
  }
  return lines.join('\n') + '\n';
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

void ResultsPanel::showController(const ControllerView& view) {
  controller_view_ = view;
  showVerdict();
}

/// What a person came for, in one line; the rest stands on the controller's own page.
void ResultsPanel::showVerdict() {
  const auto& found = controller_view_.found;
  controller_->setVisible(controller_view_.chosen != nullptr);
  if (controller_view_.failure) return controller_->setText(tr("The controller's time is not known: see Problems"));
  if (!found) return controller_->setText(tr("predicting…"));
  controller_->setText(controller_verdict(found->prediction, controller_view_.as_setpoints));
}

void ResultsPanel::setUnits(Units unit) {
  model_->setUnit(unit);
  showPlans(a_, b_);
}

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
  name_control(pin_, tr("Pin this plan as B"));
  name_control(swap_, tr("Swap A and B"));
  name_control(unpin_, tr("Let go of B"));
  name_control(cycle_, tr("Cycle time of plan A"));
  showHeadline();
  showVerdict();
  showCheckBar();
}

}  // namespace toolpace::ui
