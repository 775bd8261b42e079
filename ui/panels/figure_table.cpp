#include "panels/figure_table.h"

#include <QHeaderView>

#include "panels/results_panel.h"

namespace toolpace::ui {
namespace {

constexpr int kChip = 10;

}  // namespace

NumberItem::NumberItem(const QString& text, double value) : QTableWidgetItem(text), value_(value) {
  setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

bool NumberItem::operator<(const QTableWidgetItem& other) const {
  return value_ < static_cast<const NumberItem&>(other).value_;
}

QTableWidget* figure_table(const char* name, int columns, QWidget* parent) {
  auto* result = new QTableWidget(0, columns, parent);
  result->setObjectName(name);
  style_table(result);
  result->verticalHeader()->hide();
  result->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int i = 1; i < columns; ++i) {
    result->horizontalHeader()->setSectionResizeMode(i, QHeaderView::ResizeToContents);
  }
  return result;
}

void set_heads(QTableWidget* table, const QStringList& heads) {
  table->setHorizontalHeaderLabels(heads);
  table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (int i = 1; i < heads.size(); ++i)
    table->horizontalHeaderItem(i)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

QPixmap colour_chip(const QColor& colour) {
  QPixmap pixmap(kChip, kChip);
  pixmap.fill(colour);
  return pixmap;
}

}  // namespace toolpace::ui
