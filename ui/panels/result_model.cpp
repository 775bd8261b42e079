#include "panels/result_model.h"

#include <QFont>
#include <algorithm>
#include <cmath>

namespace toolpace::ui {
namespace {

const Summary& summary(const Planned& plan) { return plan.timeline->outcome()->summary; }

constexpr double kNoError = 1e-9;  // [mm]: rounding

double violations(const Planned& plan) {
  if (!plan.proof) return 0;
  const auto& checks = plan.proof->report.checks;
  return static_cast<double>(std::count_if(checks.begin(), checks.end(), [](const Check& c) { return c.broken; }));
}

}  // namespace

ResultModel::ResultModel(QObject* parent) : QAbstractTableModel(parent) { retranslate(); }

void ResultModel::retranslate() {
  beginResetModel();
  using P = const Planned&;
  const auto proven = [](P p, double value) { return p.proof ? value : std::nan(""); };
  const auto deviation = [](P p) { return p.proof && p.proof->tube ? p.proof->tube->largest_offset : 0.0; };
  const auto bound = [](P p) { return p.proof ? p.proof->bound : std::nan(""); };
  using enum Shown;
  rows_ = {
      {tr("Cycle time"), Quantity::time, true, quantity, [](P p) { return summary(p).cycle_time; }},
      {tr("· cutting"), Quantity::time, true, quantity, [](P p) { return summary(p).feed_time; }},
      {tr("· rapid"), Quantity::time, true, quantity, [](P p) { return summary(p).rapid_time; }, true},
      {tr("· dwell"), Quantity::time, true, quantity, [](P p) { return summary(p).dwell_time; }, true},
      {tr("Lower bound"), Quantity::time, true, quantity, bound, true},
      {tr("· plan above it"), Quantity::time, true, share,
       [bound](P p) { return bound(p) == 0 ? 0.0 : summary(p).cycle_time / bound(p) - 1; }, true},
      {tr("Peak speed"), Quantity::speed, false, quantity, [](P p) { return summary(p).peaks.speed; }},
      {tr("Peak accel."), Quantity::acceleration, false, quantity, [](P p) { return summary(p).peaks.acceleration; }},
      {tr("Peak jerk"), Quantity::jerk, false, quantity, [](P p) { return summary(p).peaks.jerk; }},
      {tr("Peak speed, rotary"), Quantity::angular_speed, false, quantity,
       [](P p) { return summary(p).rotary_peaks.speed * kRadiansPerDegree; }, true},
      {tr("Peak accel., rotary"), Quantity::angular_acceleration, false, quantity,
       [](P p) { return summary(p).rotary_peaks.acceleration * kRadiansPerDegree; }, true},
      {tr("Peak jerk, rotary"), Quantity::angular_jerk, false, quantity,
       [](P p) { return summary(p).rotary_peaks.jerk * kRadiansPerDegree; }, true},
      {tr("Violations"), Quantity::length, true, count, [proven](P p) { return proven(p, violations(p)); }},
      {tr("Contour error"), Quantity::length, true, error,
       [proven](P p) { return proven(p, p.proof ? p.proof->servo.max_contour_error : 0); }},
      {tr("Chord error"), Quantity::length, true, error,
       [proven](P p) { return proven(p, p.proof ? p.proof->report.chord_error.value_or(std::nan("")) : 0); }},
      {tr("Off the path"), Quantity::length, true, error, deviation, true},
      {tr("Mean speed"), Quantity::speed, false, quantity,
       [](P p) { return summary(p).cycle_time > 0 ? summary(p).path_length / summary(p).cycle_time : 0.0; }},
      {tr("Path length"), Quantity::length, false, quantity, [](P p) { return summary(p).path_length; }},
      {tr("Blocks"), Quantity::length, false, count, [](P p) { return static_cast<double>(summary(p).blocks); }},
  };
  endResetModel();
}

void ResultModel::setPlans(const Planned& a, const Planned& b) {
  a_ = a;
  b_ = b;
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
  if (row.shown == Shown::share) return {1e2, "%"};
  if (row.shown == Shown::error)
    unit = unit_ == LengthUnit::inch ? DisplayUnit{unit.factor * 1e3, "mil"} : DisplayUnit{1e3, "µm"};
  if (row.quantity == Quantity::jerk) unit = {unit.factor * 1e-3, "10³ " + unit.text};  // as the plots have it
  return unit;
}

QString ResultModel::text_of(const Row& row, double value) const {
  if (!std::isfinite(value)) return number_text(value);
  if (row.shown == Shown::share) return QString::number(value * 1e2, 'f', 1);
  if (row.shown == Shown::count) return number_text(value, 12);
  if (row.quantity == Quantity::time) return QString::number(value, 'f', 3);
  if (row.shown == Shown::error && std::abs(value) < kNoError) value = 0;
  return number_text(value * unit_of(row).factor, 5);
}

QString ResultModel::difference(const Row& row, double a, double b) const {
  const double delta = a - b;
  if (!std::isfinite(delta)) return "–";
  if (std::abs(delta) <= 1e-9 * std::max(std::abs(a), std::abs(b))) return "0";
  const QString sign = delta > 0 ? "+" : "−";
  if (row.read && row.quantity == Quantity::time && row.shown == Shown::quantity && b > 0) {
    return sign +
           QString::number(std::abs(delta) / b * 100, 'f',
                           std::abs(delta) >= b        ? 0
                           : std::abs(delta) / b < 0.1 ? 2
                                                       : 1) +
           " %";
  }
  return sign + text_of(row, std::abs(delta));
}

QVariant ResultModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool title = index.column() == kTitle;
  if (role == Qt::TextAlignmentRole) return QVariant((title ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (title) {
    if (role != Qt::DisplayRole) return {};
    return row.shown == Shown::count ? row.title : row.title + "  " + unit_of(row).text;
  }
  const auto value = [&row](const Planned& plan) { return plan ? std::optional(row.read(plan)) : std::nullopt; };
  const auto a = value(a_), b = value(b_);
  if (role == Qt::ForegroundRole) {
    const bool broken = row.shown == Shown::count && row.less_is_better && a && *a > 0;
    if (index.column() == kPlanA) return broken ? theme_.error : a_ ? theme_.text : theme_.secondary;
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
  return shown_value ? text_of(row, *shown_value) : QString("–");
}

bool ResultModel::isIdle(int row) const {
  const Row& r = rows_[static_cast<std::size_t>(row)];
  const auto idle = [&r](const Planned& plan) { return !plan || r.read(plan) == 0; };
  return r.may_be_hidden && idle(a_) && idle(b_);
}

QVariant ResultModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section == kTitle) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return section == kPlanA ? tr("A") : section == kPlanB ? tr("B") : QString("Δ");
}

}  // namespace toolpace::ui
