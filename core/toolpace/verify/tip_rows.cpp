#include "toolpace/verify/tip_rows.h"

#include "toolpace/verify/own_kinematics.h"

namespace toolpace {
namespace {

constexpr double kRests = 1e-10, kRestsOfAll = 1e-13;  // [mm; of the coordinates] rounding of a tip that stands still

AxisVector axes_of(const SetpointRows& rows, std::size_t row) {
  AxisVector axes = AxisVector::Zero();
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    if (!rows.position[k].empty()) axes[static_cast<Eigen::Index>(k)] = rows.position[k][row];
  }
  return axes;
}

Eigen::Vector3d told_by(const Chain& chain, const AxisVector& axes) {
  return chain.is_identity() ? Eigen::Vector3d(axes.head<3>()) : seen_tool(chain, axes).tip;
}

}  // namespace

TipRows::TipRows(SetpointFile& file, const Path& path, const Moves& moves) : file_(file), stretches_(1) {
  columns_ = file.columns();
  origin_ = file.origin();
  auto telling = path.tellings.begin();
  std::uint32_t row = 0;
  for (std::size_t i = 0; i <= path.size(); ++i) {
    const std::uint32_t end = i < path.size() ? path.move[i] : static_cast<std::uint32_t>(moves.size());
    // Rows without length belong to what stands before them.
    for (; row < end; ++row) stretches_.back().lines.insert(moves.line[row]);
    if (telling != path.tellings.end() && telling->node == i) {
      if (i > 0) stretches_.emplace_back();
      Stretch& stretch = stretches_.back();
      stretch.chain = (telling++)->chain;
      stretch.first_axes = stretch.chain.is_identity() ? path.node[i] : axes_for(stretch.chain, path.node[i]);
    }
    if (row < moves.size() && i < path.size()) stretches_.back().lines.insert(moves.line[row]);
  }
}

TipRows::TipRows(SetpointFile& file, const Chain& chain) : file_(file), stretches_(1) {
  stretches_.front().chain = chain;
  columns_ = file.columns();
  origin_ = file.origin();
}

Result<std::size_t> TipRows::read(SetpointRows& rows, std::size_t limit) {
  const std::size_t before = rows.count;
  const auto count = file_.read(rows, limit);
  if (!count) return count;
  for (auto* columns : {&rows.tip, &rows.tip_from}) {
    for (auto& column : *columns) column.resize(rows.count);
  }
  for (std::size_t row = before; row < rows.count; ++row) add_row(rows, row);
  return count;
}

void TipRows::add_row(SetpointRows& rows, std::size_t row) {
  const AxisVector axes = axes_of(rows, row);
  bool is_told_anew = false;
  while (!rows.line.empty() && stretch_ + 1 < stretches_.size() &&
         !stretches_[stretch_].lines.contains(rows.line[row]) &&
         stretches_[stretch_ + 1].lines.contains(rows.line[row])) {
    ++stretch_;
    is_told_anew = true;
  }
  const auto told = [&](const AxisVector& a) { return told_by(stretches_[stretch_].chain, a); };
  const Eigen::Vector3d from = !started_ ? told(axes) : is_told_anew ? from_before(told(axes)) : last_tip_;
  Eigen::Vector3d tip = told(axes);
  if ((tip - from).norm() <= kRests + kRestsOfAll * tip.norm()) tip = from;
  for (std::size_t k = 0; k < 3; ++k) {
    rows.tip[k][row] = tip[static_cast<Eigen::Index>(k)];
    rows.tip_from[k][row] = from[static_cast<Eigen::Index>(k)];
  }
  started_ = true;
  last_axes_ = axes;
  last_tip_ = tip;
}

/// From where the first row of a stretch has come: as far away as both ways, to the place where it begins and from there on, are
/// long.
Eigen::Vector3d TipRows::from_before(const Eigen::Vector3d& tip) const {
  const Stretch& now = stretches_[stretch_];
  const Eigen::Vector3d way = tip - told_by(now.chain, now.first_axes);
  const double before = (told_by(stretches_[stretch_ - 1].chain, now.first_axes) - last_tip_).norm();
  if (!(way.norm() > 0)) return tip - Eigen::Vector3d(before, 0, 0);
  return tip - way * (1 + before / way.norm());
}

void TipRows::rewind() {
  file_.rewind();
  stretch_ = 0;
  started_ = false;
}

}  // namespace toolpace
