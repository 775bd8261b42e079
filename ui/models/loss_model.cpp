#include "models/loss_model.h"

#include <algorithm>

namespace toolpace::ui {

void LossModel::setTimeline(std::shared_ptr<const Timeline> timeline) {
  beginResetModel();
  timeline_ = std::move(timeline);
  endResetModel();
}

void LossModel::setUnit(Units unit) {
  beginResetModel();
  unit_ = unit;
  endResetModel();
}

int LossModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() || !timeline_) return 0;
  return static_cast<int>(timeline_->worst_lines().size());
}

int LossModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

double LossModel::number(std::uint32_t line, int column) const {
  const auto& stats = timeline_->lines()[line];
  switch (column) {
    case kLine: return line;
    case kAsked: return stats.asked_speed();
    case kMean: return stats.mean_speed();
    case kTime: return stats.time;
    default: return stats.loss();
  }
}

QVariant LossModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != kSortRole) return {};
  const std::uint32_t line = timeline_->worst_lines()[static_cast<std::size_t>(index.row())];
  const double value = number(line, index.column());
  if (role == kSortRole) return value;
  switch (index.column()) {
    case kLine: return QString::number(line);
    case kAsked:
    case kMean:
      return QString::number(value * display_unit(Quantity::speed, unit_).factor, 'f',
                             decimals_of(Quantity::speed, 2, unit_));
    default: return QString::number(value, 'f', 3);
  }
}

QVariant LossModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString speed = display_unit(Quantity::speed, unit_).text;
  switch (section) {
    case kLine: return tr("Line");
    case kAsked: return tr("Feed") + "\n" + speed;
    case kMean: return tr("Mean") + "\n" + speed;
    case kTime: return tr("Time") + "\ns";
    default: return tr("Loss") + "\ns";
  }
}

}  // namespace toolpace::ui
