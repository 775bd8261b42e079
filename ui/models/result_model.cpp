#include "models/result_model.h"

#include <QFont>
#include <cmath>

namespace toolpace::ui {

ResultModel::ResultModel(QObject* parent) : QAbstractTableModel(parent) { retranslate(); }

void ResultModel::retranslate() {
  beginResetModel();
  using S = const Summary&;
  rows_ = {
      {tr("Cycle time"), Quantity::time, true, false, [](S s) { return s.cycle_time; }},
      {tr("· cutting"), Quantity::time, true, false, [](S s) { return s.feed_time; }},
      {tr("· rapid"), Quantity::time, true, false, [](S s) { return s.rapid_time; }},
      {tr("· dwell"), Quantity::time, true, false, [](S s) { return s.dwell_time; }},
      {tr("Top speed"), Quantity::speed, false, false, [](S s) { return s.max_speed; }},
      {tr("Mean speed"), Quantity::speed, false, false,
       [](S s) { return s.cycle_time > 0 ? s.path_length / s.cycle_time : 0.0; }},
      {tr("Peak acceleration"), Quantity::acceleration, false, false, [](S s) { return s.max_acceleration; }},
      {tr("Peak jerk"), Quantity::jerk, false, false, [](S s) { return s.max_jerk; }},
      {tr("Path length"), Quantity::length, false, false, [](S s) { return s.path_length; }},
      {tr("Blocks"), Quantity::length, false, true, [](S s) { return static_cast<double>(s.blocks); }},
  };
  endResetModel();
}

void ResultModel::setPlans(std::shared_ptr<const Timeline> a, std::shared_ptr<const Timeline> b) {
  a_ = std::move(a);
  b_ = std::move(b);
  if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void ResultModel::setUnit(LengthUnit unit) {
  beginResetModel();
  unit_ = unit;
  endResetModel();
}

void ResultModel::setTheme(const Theme& theme) {
  beginResetModel();
  theme_ = theme;
  endResetModel();
}

int ResultModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ResultModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

DisplayUnit ResultModel::unit_of(const Row& row) const {
  DisplayUnit unit = display_unit(row.quantity, unit_);
  if (row.quantity == Quantity::jerk) unit = {unit.factor * 1e-3, "10³ " + unit.text};  // as the plots have it
  return unit;
}

QString ResultModel::shown(const Row& row, double value) const {
  if (row.is_count) return number_text(value, 12);
  if (row.quantity == Quantity::time) return QString::number(value, 'f', 3);
  return number_text(value * unit_of(row).factor, 5);
}

QString ResultModel::difference(const Row& row, double a, double b) const {
  const double delta = a - b;
  if (!std::isfinite(delta)) return "–";
  if (std::abs(delta) <= 1e-9 * std::max(std::abs(a), std::abs(b))) return "0";
  const QString sign = delta > 0 ? "+" : "−";
  if (row.read && row.quantity == Quantity::time && !row.is_count && b > 0) {
    return sign + QString::number(std::abs(delta) / b * 100, 'f', std::abs(delta) / b < 0.1 ? 2 : 1) + " %";
  }
  return sign + shown(row, std::abs(delta));
}

QVariant ResultModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  const auto value = [&row](const std::shared_ptr<const Timeline>& plan) {
    return plan ? std::optional(row.read(plan->outcome()->summary)) : std::nullopt;
  };
  const auto a = value(a_), b = value(b_);
  if (role == Qt::ForegroundRole) {
    if (index.column() == kPlanA) return a_ ? theme_.text : theme_.secondary;
    if (index.column() == kPlanB) return b_ ? theme_.plan_b : theme_.secondary;
    if (!a || !b || !row.less_is_better || std::abs(*a - *b) <= 1e-9 * std::abs(*b)) return theme_.secondary;
    return *a < *b ? theme_.good : theme_.error;
  }
  if (role == Qt::FontRole && index.row() == 0) {
    QFont font;
    font.setWeight(QFont::DemiBold);
    return font;
  }
  if (role != Qt::DisplayRole) return {};
  if (index.column() == kDelta) return a && b ? difference(row, *a, *b) : QString("–");
  const auto& shown_value = index.column() == kPlanA ? a : b;
  return shown_value ? shown(row, *shown_value) : QString("–");
}

QVariant ResultModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    if (role != Qt::DisplayRole) return {};
    const Row& row = rows_[static_cast<std::size_t>(section)];
    return row.is_count ? row.title : row.title + "  " + unit_of(row).text;
  }
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return section == kPlanA ? tr("A") : section == kPlanB ? tr("B") : QString("Δ");
}

}  // namespace toolpace::ui
