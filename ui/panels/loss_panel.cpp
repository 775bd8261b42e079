#include "panels/loss_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QVBoxLayout>

#include "panels/results_panel.h"

namespace toolpace::ui {

LossPanel::LossPanel(QWidget* parent)
    : QWidget(parent),
      model_(new LossModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)),
      total_(new QLabel(this)) {
  setObjectName("lossPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  total_->setContentsMargins(8, 8, 8, 4);
  total_->setProperty("role", "secondary");
  total_->setWordWrap(true);
  column->addWidget(total_);
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(LossModel::kSortRole);
  table_->setObjectName("lossTable");
  table_->setModel(sorted_);
  style_table(table_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(LossModel::kLoss, Qt::DescendingOrder);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);  // every column is always in sight
  table_->horizontalHeader()->setMinimumSectionSize(40);
  column->addWidget(table_, 1);
  const auto go = [this](const QModelIndex& index) {
    emit lineRequested(index.siblingAtColumn(LossModel::kLine).data(LossModel::kSortRole).toInt());
  };
  connect(table_, &QTableView::clicked, this, go);
  connect(table_, &QTableView::activated, this, go);
  showTotal();
}

void LossPanel::showPlans(const Planned& plan, const Planned&) {
  timeline_ = plan.timeline;
  update();
}

// Sorting the lines takes longer than all that a drag draws, so nothing is done before the panel is seen. Docks behind
// other tabs count as visible, but they are not painted.
void LossPanel::refresh() {
  if (shown_ == timeline_) return;
  shown_ = timeline_;
  model_->setTimeline(timeline_);
  showTotal();
}

void LossPanel::paintEvent(QPaintEvent* event) {
  if (shown_ != timeline_) QMetaObject::invokeMethod(this, &LossPanel::refresh, Qt::QueuedConnection);
  QWidget::paintEvent(event);
}

void LossPanel::setUnits(Units unit) { model_->setUnit(unit); }

void LossPanel::showTotal() {
  table_->setAccessibleName(tr("Time lost by each NC line"));
  if (!timeline_) return total_->clear();
  const double loss = timeline_->total_loss();
  const double share = timeline_->duration() > 0 ? loss / timeline_->duration() * 100 : 0;
  const auto lines = static_cast<qulonglong>(timeline_->losing_lines());
  const QString where = lines == 1 ? tr("on one line") : tr("on %1 lines").arg(lines);
  total_->setText(tr("%1 s (%2 %) more than at the programmed feed all along, %3")
                      .arg(QString::number(loss, 'f', 3), QString::number(share, 'f', 1), where));
}

void LossPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    showTotal();
    emit model_->headerDataChanged(Qt::Horizontal, 0, LossModel::kColumns - 1);
  }
  QWidget::changeEvent(event);
}

}  // namespace toolpace::ui
