#include "panels/figure_list.h"

#include <QGridLayout>
#include <QStyle>

#include "panels/form_grid.h"

namespace toolpace::ui {

FigureList::FigureList(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
}

void FigureList::add(const QString& object_name) {
  auto* grid = static_cast<QGridLayout*>(layout());
  const Row row{secondary_label({}, this), new QLabel(this), secondary_label({}, this)};
  row.value->setObjectName(object_name);
  row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  const int at = static_cast<int>(rows_.size());
  grid->addWidget(row.name, at, 0);
  grid->addWidget(row.value, at, 1);
  grid->addWidget(row.unit, at, 2);
  rows_.push_back(row);
}

void FigureList::setName(std::size_t row, const QString& name) {
  rows_.at(row).name->setText(name);
  rows_.at(row).value->setAccessibleName(name);
}

void set_role(QLabel* label, const char* role) {
  label->setProperty("role", role);
  label->style()->unpolish(label);
  label->style()->polish(label);
}

}  // namespace toolpace::ui
