#include "panels/result_model.h"

#include <QFont>
#include <algorithm>
#include <cmath>

namespace toolpace::ui {
namespace {

const Summary& summary(const Planned& plan) { return plan.timeline->outcome()->summary; }

constexpr double kNoError = 1e-9;  // [mm]: rounding

double violations(const Proof& proof) {
  const auto& checks = proof.report.checks;
  return static_cast<double>(std::count_if(checks.begin(), checks.end(), [](const Check& c) { return c.broken; }));
}

/// Not a number where the setpoints do not follow the path at all.
double deviation(const Proof& proof) {
  const auto& checks = proof.report.checks;
  const auto found =
      std::find_if(checks.begin(), checks.end(), [](const Check& c) { return c.kind == CheckKind::deviation; });
  return found == checks.end() ? std::nan("") : found->value;
}

}  // namespace

ResultModel::ResultModel(QObject* parent) : QAbstractTableModel(parent) { retranslate(); }

void ResultModel::retranslate() {
  beginResetModel();
  rows_.clear();
  addTimes();
  addPeaks();
  addProven();
  addSizes();
  if (a_ && b_) differences_ = setting_differences(*a_.timeline->outcome()->job, *b_.timeline->outcome()->job, unit_);
  endResetModel();
}

void ResultModel::addTimes() {
  using P = const Planned&;
  using enum Shown;
  const auto bound = [](P p) { return p.proof ? p.proof->bound : std::nan(""); };
  const auto time = [this](const QString& title, const QString& tip, auto read, bool may_be_hidden) {
    rows_.push_back({title, tip, Quantity::time, true, quantity, read, may_be_hidden});
  };
  time(
      tr("Cycle time"), tr("From the first move to the last, dwells and tool changes included: T = Σ Δt"),
      [](P p) { return summary(p).cycle_time; }, false);
  time(
      tr("· cutting"), tr("Time in moves with a feed: G1, G2, G3, splines; Σ Δt of these"),
      [](P p) { return summary(p).feed_time; }, false);
  time(
      tr("· rapid"), tr("Time in rapid moves: G0"), [](P p) { return summary(p).rapid_time; }, true);
  time(
      tr("· dwell"), tr("Time at rest: G4, tool changes"), [](P p) { return summary(p).dwell_time; }, true);
  time(tr("Lower bound"), tr("No plan that keeps these limits and this tolerance is faster than this: T ≥ bound"),
       bound, true);
  rows_.push_back({tr("· plan above it"), tr("Cycle time / lower bound − 1: what a better plan could save at most"),
                   Quantity::time, true, share,
                   [bound](P p) { return bound(p) == 0 ? 0.0 : summary(p).cycle_time / bound(p) - 1; }, true});
}

void ResultModel::addPeaks() {
  using P = const Planned&;
  const auto peak = [this](const QString& title, const QString& tip, Quantity quantity, auto read) {
    rows_.push_back({title, tip, quantity, false, Shown::quantity, read});
  };
  const auto rotary = [this](const QString& title, Quantity quantity, double Peaks::*which) {
    rows_.push_back({title, tr("Where A, B or C move alone"), quantity, false, Shown::quantity,
                     [which](P p) { return summary(p).rotary_peaks.*which * kRadiansPerDegree; }, true});
  };
  peak(tr("Peak speed"), tr("Largest v = ds/dt along the path"), Quantity::speed,
       [](P p) { return summary(p).peaks.speed; });
  peak(tr("Peak accel."), tr("Largest |a| = |dv/dt| along the path"), Quantity::acceleration,
       [](P p) { return summary(p).peaks.acceleration; });
  peak(tr("Peak jerk"), tr("Largest |j| = |da/dt| along the path; ∞: acceleration changes in steps"), Quantity::jerk,
       [](P p) { return p.series->is_jerk_unbounded() ? kUnlimited : summary(p).peaks.jerk; });
  rotary(tr("Peak speed, rotary"), Quantity::angular_speed, &Peaks::speed);
  rotary(tr("Peak accel., rotary"), Quantity::angular_acceleration, &Peaks::acceleration);
  rotary(tr("Peak jerk, rotary"), Quantity::angular_jerk, &Peaks::jerk);
}

void ResultModel::addProven() {
  using P = const Planned&;
  using enum Shown;
  const auto proven = [](auto read) { return [read](P p) { return p.proof ? read(*p.proof) : std::nan(""); }; };
  rows_.push_back({tr("Violations"),
                   tr("Limits that the setpoints break, found by an independent check of them: |Δx/Δt| > v and so on"),
                   Quantity::length, true, count, proven(violations)});
  const auto error_row = [this](const QString& title, const QString& tip, auto read, bool may_be_hidden = false) {
    rows_.push_back({title, tip, Quantity::length, true, error, read, may_be_hidden});
  };
  error_row(tr("Contour error"),
            tr("Cutting: largest distance of the simulated drives from the commanded path, max |actual − path|; being "
               "late is left out"),
            proven([](const Proof& p) { return p.contour.cutting; }));
  error_row(tr("· in rapids"), tr("The same while the tool does not cut"),
            proven([](const Proof& p) { return p.contour.rapid; }), true);
  error_row(tr("Chord error"),
            tr("How far the straight lines between setpoints cut off the planned motion, about (v·Ts)²/8r on an arc"),
            proven([](const Proof& p) { return p.chord_error; }));
  error_row(
      tr("Off the path"),
      tr("Largest distance of the setpoints from the programmed path, as the check measures it: max |setpoint − path|"),
      [](P p) {
        if (!leaves_programmed_path(*p.timeline->outcome())) return 0.0;
        return p.proof ? deviation(*p.proof) : std::nan("");
      },
      true);
}

void ResultModel::addSizes() {
  using P = const Planned&;
  rows_.push_back(
      {tr("Mean speed"), tr("Path length / cycle time: s / T"), Quantity::speed, false, Shown::quantity,
       [](P p) { return summary(p).cycle_time > 0 ? summary(p).path_length / summary(p).cycle_time : 0.0; }});
  rows_.push_back({tr("Path length"), tr("As it is run, rapids included: s = ∫ v dt"), Quantity::length, false,
                   Shown::quantity, [](P p) { return summary(p).path_length; }});
  rows_.push_back({tr("Blocks"), tr("Motion blocks of the program"), Quantity::length, false, Shown::count,
                   [](P p) { return static_cast<double>(summary(p).blocks); }});
}

void ResultModel::setPlans(const Planned& a, const Planned& b) {
  const bool others = (a ? a.timeline->outcome()->job : nullptr) != (a_ ? a_.timeline->outcome()->job : nullptr) ||
                      (b ? b.timeline->outcome()->job : nullptr) != (b_ ? b_.timeline->outcome()->job : nullptr);
  a_ = a;
  b_ = b;
  if (others) compareSettings();
  if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void ResultModel::compareSettings() {
  auto now = a_ && b_ ? setting_differences(*a_.timeline->outcome()->job, *b_.timeline->outcome()->job, unit_)
                      : std::vector<SettingDifference>{};
  if (now.empty() && differences_.empty()) return;
  beginResetModel();
  differences_ = std::move(now);
  endResetModel();
}

/// A heading, and a row for each setting.
QVariant ResultModel::settingData(int row, int column, int role) const {
  if (column != kTitle) return {};
  const auto at = static_cast<std::size_t>(row) - rows_.size();
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
  if (at == 0) {
    if (role == Qt::DisplayRole) return tr("Settings that differ");
    if (role == Qt::ToolTipRole) return tr("What decides plans A and B, where it is not the same");
    QFont font;
    font.setWeight(QFont::DemiBold);
    return role == Qt::FontRole ? QVariant(font) : QVariant();
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const SettingDifference& d = differences_[at - 1];
  const QString values = tr("A %1 · B %2").arg(d.a, d.b);
  return role == Qt::DisplayRole ? d.title + "  " + values : d.title + "\n" + values;
}

void ResultModel::setProofState(ProofService::State state) {
  proof_state_ = state;
  if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void ResultModel::setUnit(Units unit) {
  beginResetModel();
  unit_ = unit;
  if (a_ && b_) differences_ = setting_differences(*a_.timeline->outcome()->job, *b_.timeline->outcome()->job, unit_);
  endResetModel();
}

void ResultModel::setTheme(const Theme& theme) {
  beginResetModel();
  theme_ = theme;
  endResetModel();
}

int ResultModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  return static_cast<int>(rows_.size() + (differences_.empty() ? 0 : differences_.size() + 1));
}

int ResultModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

DisplayUnit ResultModel::unit_of(const Row& row) const {
  DisplayUnit unit = display_unit(row.quantity, unit_);
  if (row.shown == Shown::share) return {1e2, "%"};
  if (row.shown == Shown::error) return error_unit(unit_);
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

/// Why a figure is not there.
QString ResultModel::missing(bool is_a) const {
  using State = ProofService::State;
  if (!is_a) return tr("Not checked before it was pinned");
  switch (proof_state_) {
    case State::running: return tr("Still being computed");
    case State::too_long:
      return tr("More than %1 setpoints: only where you ask for it").arg(number_text(kProvenUnasked, 9));
    case State::stopped: return tr("The check was stopped");
    case State::idle: break;
  }
  return tr("There is no such figure for this plan");
}

QString ResultModel::tipOf(const Row& row, int column) const {
  const Planned& plan = column == kPlanB ? b_ : a_;
  if (column == kDelta || column == kTitle || !plan || !std::isnan(row.read(plan))) return row.tip;
  return missing(column == kPlanA);
}

QVariant ResultModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (isSetting(index.row())) return settingData(index.row(), index.column(), role);
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool title = index.column() == kTitle;
  if (role == Qt::TextAlignmentRole) return QVariant((title ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) return tipOf(row, index.column());
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
  const bool comes = index.column() == kPlanA && proof_state_ == ProofService::State::running;
  if (shown_value && std::isnan(*shown_value) && comes) return QString("…");
  return shown_value ? text_of(row, *shown_value) : QString("–");
}

bool ResultModel::isIdle(int row) const {
  if (isSetting(row)) return false;
  const Row& r = rows_[static_cast<std::size_t>(row)];
  const auto idle = [&r](const Planned& plan) {
    if (!plan) return true;
    const double value = r.read(plan);
    return value == 0 || (r.shown == Shown::error && std::abs(value) < kNoError);
  };
  return r.may_be_hidden && idle(a_) && idle(b_);
}

QVariant ResultModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section == kTitle) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return section == kPlanA ? tr("A") : section == kPlanB ? tr("B") : QString("Δ");
}

}  // namespace toolpace::ui
