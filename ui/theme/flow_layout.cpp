#include "theme/flow_layout.h"

#include <QWidget>
#include <algorithm>

namespace toolpace::ui {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {}

FlowLayout::~FlowLayout() {
  for (QLayoutItem* item : items_) delete item;
}

void FlowLayout::addItem(QLayoutItem* item) { items_.push_back(item); }

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  QLayoutItem* const item = itemAt(index);
  if (item) items_.erase(items_.begin() + index);
  return item;
}

std::vector<FlowLayout::Row> FlowLayout::rowsFor(int width) const {
  std::vector<Row> rows;
  int room = 0;
  for (QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    const int wide = item->sizeHint().width();
    if (rows.empty() || wide > room) {
      rows.emplace_back();
      room = width;
    }
    rows.back().push_back(item);
    room -= wide + spacing();
  }
  return rows;
}

/// @return the height that it takes
int FlowLayout::arrange(const QRect& rect, bool move) const {
  const QMargins margins = contentsMargins();
  const QRect room = rect.marginsRemoved(margins);
  int y = room.y();
  for (const Row& row : rowsFor(room.width())) {
    int high = 0, x = room.x();
    for (const QLayoutItem* item : row) high = std::max(high, item->sizeHint().height());
    for (QLayoutItem* item : row) {
      const bool last = item == items_.back();
      const int wide = last ? std::max(room.right() + 1 - x, 0) : std::min(item->sizeHint().width(), room.width());
      if (move) item->setGeometry({x, y, wide, high});
      x += wide + spacing();
    }
    y += high + spacing();
  }
  const int gap = y > room.y() ? spacing() : 0;  // none below the last row
  return y - gap + margins.bottom() - rect.y();
}

int FlowLayout::heightForWidth(int width) const { return arrange({0, 0, width, 0}, false); }

QSize FlowLayout::minimumSize() const {
  QSize least;
  for (const QLayoutItem* item : items_) {
    if (!item->isEmpty()) least = least.expandedTo(item->sizeHint());
  }
  return least.grownBy(contentsMargins());
}

QSize FlowLayout::sizeHint() const {
  int wide = 0, high = 0;
  for (const QLayoutItem* item : items_) {
    if (item->isEmpty()) continue;
    wide += item->sizeHint().width() + spacing();
    high = std::max(high, item->sizeHint().height());
  }
  return QSize(std::max(wide - spacing(), 0), high).grownBy(contentsMargins());
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  const int high = arrange(rect, true);
  // Not all that lies above asks how high it is at a width: a main window does not.
  if (QWidget* const widget = parentWidget(); widget->layout() == this && widget->minimumHeight() != high)
    widget->setMinimumHeight(high);
}

}  // namespace toolpace::ui
