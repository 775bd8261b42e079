#pragma once
/// Titles of tables with their unit in the secondary colour.

#include <QStyledItemDelegate>

#include "theme/theme.h"

namespace toolpace::ui {

/// Draws "Peak speed  mm/s": what stands behind two spaces is the unit.
class UnitDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void setTheme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
