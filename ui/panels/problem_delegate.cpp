#include "panels/problem_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QTableView>

#include "models/problem_model.h"

namespace toolpace::ui {
namespace {

constexpr int kWrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

int height_of(const QString& text, const QFontMetrics& metrics, int width) {
  return text.isEmpty() ? 0 : metrics.boundingRect(0, 0, width, 1 << 20, kWrapped, text).height();
}

QString remedy_at(const QModelIndex& index) { return index.data(ProblemModel::kRemedyRole).toString(); }

}  // namespace

ProblemDelegate::ProblemDelegate(QTableView* table) : QStyledItemDelegate(table), table_(table) {}

QSize ProblemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int width = std::max(table_->columnWidth(index.column()) - 2 * kSide, 40);
  const QFontMetrics metrics(option.font);
  const int text = height_of(index.data().toString(), metrics, width) + height_of(remedy_at(index), metrics, width);
  return {width, text + 2 * kAbove};
}

void ProblemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QString message = item.text, remedy = remedy_at(index);
  item.text.clear();
  const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
  QRect room = option.rect.adjusted(kSide, kAbove, -kSide, -kAbove);
  painter->save();
  painter->setFont(option.font);
  painter->setPen(theme_.text);
  painter->drawText(room, kWrapped, message);
  room.setTop(room.top() + height_of(message, QFontMetrics(option.font), room.width()));
  painter->setPen(theme_.secondary);
  painter->drawText(room, kWrapped, remedy);
  painter->restore();
}

}  // namespace toolpace::ui
