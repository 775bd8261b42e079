#include "toolpace/path/turn_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/kinematics/great_circle.h"

namespace toolpace {
namespace {

bool turns_in_plane(const Path& path, std::size_t i) {
  const Chain* const chain = path.chain_of(i);
  return chain != nullptr && chain->orientation == Orientation::plane;
}

/// By the length [deg] of the curve of A B C instead of the share.
RotaryPlace by_degrees(const RotaryPlace& p) {
  const double rate = p.first.norm() / kRadiansPerDegree;
  if (!(rate > 0)) return p;
  const Eigen::Vector3d first = p.first / rate;
  const double change = p.first.dot(p.second) / p.first.norm() / kRadiansPerDegree;
  return {p.angle, first, (p.second - first * change) / (rate * rate)};
}

RotaryPlace by_length(const RotaryPlace& p, double length) {
  return {p.angle, p.first / length, p.second / (length * length)};
}

/// Length of the curve of A B C [deg], by Gauss' rule.
double degrees_of(const RotaryTurn& turn, double share) {
  constexpr std::array<double, 3> kNode = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> kWeight = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double rate = 0;
  for (std::size_t k = 0; k < kNode.size(); ++k) rate += kWeight[k] * turn.at(kNode[k] * share)[1].norm();
  return rate * share / kRadiansPerDegree;
}

class Turner {
 public:
  explicit Turner(Path path) : in_(std::move(path)) {
    out_.arcs = in_.arcs;
    out_.splines = std::move(in_.splines);
    out_.spline_pieces = std::move(in_.spline_pieces);
    out_.tellings = in_.tellings;
    out_.node.push_back(in_.node.front());
    for (auto* column : {&out_.move, &out_.detail, &out_.turn}) column->reserve(in_.size());
    out_.kind.reserve(in_.size());
    out_.length.reserve(in_.size());
    out_.node.reserve(in_.size() + 1);
    place_.reserve(in_.size() + 1);
  }

  Path run() {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      place_.push_back(static_cast<std::uint32_t>(out_.size()));
      add(i);
    }
    place_.push_back(static_cast<std::uint32_t>(out_.size()));
    for (Path::Pause pause : in_.pauses) {
      pause.node = place_[pause.node];
      out_.pauses.push_back(pause);
    }
    for (Path::Telling& telling : out_.tellings) telling.node = place_[telling.node];
    if (out_.turns.empty()) out_.turn.clear();
    out_.position = NodePositions(out_.length);
    return std::move(out_);
  }

 private:
  void push(std::size_t i, double length, std::uint32_t detail, std::uint32_t turn, const AxisVector& end) {
    out_.kind.push_back(in_.kind[i]);
    out_.move.push_back(in_.move[i]);
    out_.length.push_back(length);
    out_.detail.push_back(detail);
    out_.turn.push_back(turn);
    out_.node.push_back(end);
  }

  void add(std::size_t i) {
    if (turns_in_plane(in_, i) && in_.node[i].tail<3>() != in_.end_of(i).tail<3>()) {
      const auto places =
          in_.kind[i] <= SegmentKind::arc ? turn_in_plane(*in_.chain_of(i), in_.node[i], in_.end_of(i)) : std::nullopt;
      if (places && !places->empty()) return add_turns(i, *places);
      if (!places && (out_.out_of_plane.empty() || out_.out_of_plane.back() != in_.move[i]))
        out_.out_of_plane.push_back(in_.move[i]);
    }
    push(i, in_.length[i], in_.detail[i], kNoDetail, in_.node[i + 1]);
  }

  void add_turns(std::size_t i, const std::vector<SharePlace>& places) {
    const double whole = in_.length[i];
    const bool rotary_only = is_rotary_only(in_, i);
    for (std::size_t k = 1; k < places.size(); ++k) {
      const RotaryPlace &from = places[k - 1].place, &to = places[k].place;
      const double begin = places[k - 1].share, end = places[k].share;
      double length = (end - begin) * whole;
      if (rotary_only) {
        length = degrees_of(turn_between(from, to, end - begin), end - begin);
        out_.turns.push_back(turn_between(by_degrees(from), by_degrees(to), length));
      } else {
        out_.turns.push_back(turn_between(by_length(from, whole), by_length(to, whole), length));
      }
      std::uint32_t detail = in_.detail[i];
      if (in_.kind[i] == SegmentKind::arc) {
        out_.arcs.push_back(part_of_arc(in_.arcs[in_.detail[i]], whole, begin * whole, end * whole));
        detail = static_cast<std::uint32_t>(out_.arcs.size() - 1);
      }
      AxisVector node = in_.node[i + 1];
      if (k + 1 < places.size()) {
        node = rotary_only ? in_.node[i] : point_at(in_, i, end * whole);
        node.tail<3>() = to.angle;
      }
      push(i, length, detail, static_cast<std::uint32_t>(out_.turns.size() - 1), node);
    }
  }

  Path in_, out_;
  std::vector<std::uint32_t> place_;  ///< of each old node among the new ones
};

}  // namespace

Path turn_tool(Path path) {
  const bool any = std::any_of(path.tellings.begin(), path.tellings.end(),
                               [](const Path::Telling& t) { return t.chain.orientation == Orientation::plane; });
  return any ? Turner(std::move(path)).run() : path;
}

Diagnostics check_planes(const Path& path, const Moves& moves) {
  if (path.out_of_plane.empty()) return {};
  const std::size_t count = path.out_of_plane.size();
  Diagnostic warning;
  warning.severity = Severity::warning;
  warning.code = "out-of-plane";
  warning.message = fmt::format(
      "here and in {} other blocks the rotary axes turn evenly: no way in the plane of both tool directions leads to "
      "the "
      "programmed angles",
      count - 1);
  if (count == 1) {
    warning.message =
        "the rotary axes turn evenly here: no way in the plane of both tool directions leads to the programmed angles";
  }
  warning.remedy = "turn the farther rotary axis before the tool is tilted, in a block of its own";
  const std::uint32_t row = path.out_of_plane.front();
  warning.where.line = moves.line[row];
  if (!moves.files.empty()) warning.where.file = moves.files[moves.file[row]];
  return {warning};
}

}  // namespace toolpace
