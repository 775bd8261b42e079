#pragma once
/// A problem with what to do about it below it, as high as both take.

#include <QStyledItemDelegate>

#include "theme/theme.h"

class QTableView;

namespace toolpace::ui {

/// For the column of messages of a table over a ProblemModel.
class ProblemDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  static constexpr int kSide = 6, kAbove = 3;  ///< around what a cell holds [px]; sideways the style sheet's too

  explicit ProblemDelegate(QTableView* table);
  void setTheme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  QTableView* table_;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
