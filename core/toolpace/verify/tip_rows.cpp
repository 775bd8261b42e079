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
      stretches_.back().chain = (telling++)->chain;
    }
    if (row < moves.size() && i < path.size()) stretches_.back().lines.insert(moves.line[row]);
  }
}

TipRows::TipRows(SetpointFile& file, const Chain& chain) : file_(file), stretches_{{chain, {}}} {
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
  const Chain& chain = stretches_[stretch_].chain;
  const auto told = [&](const AxisVector& a) -> Eigen::Vector3d {
    return chain.is_identity() ? Eigen::Vector3d(a.head<3>()) : seen_tool(chain, a).tip;
  };
  const Eigen::Vector3d from = !started_ ? told(axes) : is_told_anew ? told(last_axes_) : last_tip_;
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

void TipRows::rewind() {
  file_.rewind();
  stretch_ = 0;
  started_ = false;
}

}  // namespace toolpace
