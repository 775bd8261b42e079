#include "panels/form_grid.h"

#include <QHBoxLayout>

namespace toolpace::ui {
namespace {

constexpr int kColumnsPerSide = 4;  // label, field, unit, space
constexpr int kRowSpacing = 3;
constexpr int kPairLabel = 36, kUnitWidth = 42, kWideLabel = 72, kSpacing = 4;

}  // namespace

QWidget* kept_together(std::initializer_list<QWidget*> parts, QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (QWidget* part : parts) row->addWidget(part);
  return box;
}

QLabel* secondary_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "secondary");
  return label;
}

FormGrid::FormGrid(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(kRowSpacing);
}

QGridLayout* FormGrid::grid(bool wide) {
  QGridLayout*& current = wide ? wide_ : pairs_;
  (wide ? pairs_ : wide_) = nullptr;  // rows stay in the order in which they are added
  if (current) return current;
  current = new QGridLayout;
  current->setHorizontalSpacing(kSpacing);
  current->setVerticalSpacing(kRowSpacing);
  column_->addLayout(current);
  if (wide) {
    current->setColumnMinimumWidth(0, kWideLabel);
    current->setColumnStretch(1, 1);
    return current;
  }
  for (int side : {0, 1}) {
    current->setColumnMinimumWidth(side * kColumnsPerSide, kPairLabel);
    current->setColumnMinimumWidth(side * kColumnsPerSide + 2, kUnitWidth);
    current->setColumnStretch(side * kColumnsPerSide + 1, 1);
  }
  current->setColumnMinimumWidth(3, kSpacing);
  return current;
}

QLabel* FormGrid::add(int row, int side, NumberField* field) {
  const int column = side * kColumnsPerSide;
  auto* label = new QLabel(this);
  label->setBuddy(field);
  auto* unit = secondary_label(field->unitText(), this);
  connect(field, &NumberField::unitChanged, unit, [field, unit] { unit->setText(field->unitText()); });
  QGridLayout* pairs = grid(false);
  pairs->addWidget(label, row, column);
  pairs->addWidget(field, row, column + 1);
  pairs->addWidget(unit, row, column + 2);
  parts_.push_back({field, {label, unit}});
  return label;
}

QLabel* FormGrid::addWide(int row, QWidget* widget) {
  auto* label = new QLabel(this);
  label->setBuddy(widget);
  QGridLayout* rows = grid(true);
  rows->addWidget(label, row, 0);
  rows->addWidget(widget, row, 1);
  parts_.push_back({widget, {label}});
  return label;
}

void FormGrid::setRowUseless(QWidget* field, const QString& reason) {
  for (auto& parts : parts_) {
    if (parts.field != field) continue;
    field->setEnabled(reason.isEmpty());
    if (!reason.isEmpty()) field->setToolTip(reason);
    for (auto* other : parts.others) other->setEnabled(reason.isEmpty());
  }
}

void FormGrid::setRowVisible(QWidget* field, bool visible) {
  for (auto& parts : parts_) {
    if (parts.field != field) continue;
    field->setVisible(visible);
    for (auto* other : parts.others) other->setVisible(visible);
  }
}

}  // namespace toolpace::ui
