#include "plots/value_table.h"

#include <algorithm>

namespace toolpace::ui {
namespace {

struct ColumnStyle {
  const char* title;
  Quantity quantity;
  int decimals;
};
ColumnStyle style_of(int column) {
  if (column == ValueTable::kTime) return {"t", Quantity::time, 4};
  if (column == ValueTable::kDistance) return {"s", Quantity::length, 3};
  const MotionTrack& track = kMotionTracks[static_cast<std::size_t>(column - ValueTable::kFirstTrack)];
  return {track.symbol, track.quantity, track.decimals};
}

double value_of(int column, double time, const PhaseState& state) {
  if (column == ValueTable::kTime) return time;
  if (column == ValueTable::kDistance) return state.distance;
  return kMotionTracks[static_cast<std::size_t>(column - ValueTable::kFirstTrack)].value(state);
}

}  // namespace

void ValueTable::setSeries(std::shared_ptr<const ProfileSeries> series) {
  beginResetModel();
  series_ = std::move(series);
  endResetModel();
}

void ValueTable::setRange(double begin, double end) {
  begin_ = begin;
  end_ = end;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(kRows - 1, kColumns - 1));
}

void ValueTable::setUnit(Units unit) {
  beginResetModel();
  unit_ = unit;
  endResetModel();
}

double ValueTable::timeOf(int row) const {
  const double total = series_ ? series_->duration() : 0.0;
  const double begin = std::clamp(begin_, 0.0, total), end = std::clamp(end_, begin, total);
  return begin + (end - begin) * row / (kRows - 1);
}

int ValueTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !series_ || series_->is_empty() ? 0 : kRows;
}

int ValueTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ValueTable::data(const QModelIndex& index, int role) const {
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole || !series_ || series_->is_empty()) return {};
  const double time = timeOf(index.row());
  const ColumnStyle style = style_of(index.column());
  if (index.column() == kFirstTrack + static_cast<int>(kJerkTrack) && series_->is_jerk_unbounded()) return "–";
  return QString::number(
      value_of(index.column(), time, series_->state_at(time)) * display_unit(style.quantity, unit_).factor, 'f',
      decimals_of(style.quantity, style.decimals, unit_));
}

QVariant ValueTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const ColumnStyle style = style_of(section);
  return QString("%1  %2").arg(style.title, display_unit(style.quantity, unit_).text);
}

QString ValueTable::text() const {
  QString out;
  for (int row = -1; row < rowCount(); ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const QVariant cell =
          row < 0 ? headerData(column, Qt::Horizontal, Qt::DisplayRole) : data(index(row, column), Qt::DisplayRole);
      out += cell.toString() + (column + 1 < kColumns ? '\t' : '\n');
    }
  }
  return out;
}

}  // namespace toolpace::ui
