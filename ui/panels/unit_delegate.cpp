#include "panels/unit_delegate.h"

#include <QApplication>
#include <QPainter>

namespace toolpace::ui {

void UnitDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QString text = item.text;
  const qsizetype gap = text.lastIndexOf(QStringLiteral("  "));
  if (gap < 0) return QStyledItemDelegate::paint(painter, option, index);
  const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
  const QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, &item, item.widget);
  item.text = text.left(gap);
  style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
  const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, item.widget) + 1;
  const int begin = item.fontMetrics.horizontalAdvance(text.left(gap + 2)) + margin;
  painter->save();
  painter->setFont(item.font);
  painter->setPen(theme_.secondary);
  painter->drawText(room.adjusted(begin, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                    item.fontMetrics.elidedText(text.mid(gap + 2), Qt::ElideRight, room.width() - begin));
  painter->restore();
}

}  // namespace toolpace::ui
