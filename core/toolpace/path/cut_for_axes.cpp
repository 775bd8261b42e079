#include "toolpace/path/cut_for_axes.h"

#include <algorithm>
#include <cmath>

#include "toolpace/path/arc.h"

namespace toolpace {
namespace {

constexpr double kPieceTurn = 0.15;  // [rad] of both rotary axes together, on a piece
constexpr double kMostPieces = 1e5;

std::size_t pieces_of(const Path& path, std::size_t i) {
  if (path.kind[i] > SegmentKind::arc || path.chain_of(i) == nullptr || path.turn_of(i) != nullptr) return 1;
  const AxisVector turn = path.end_of(i) - path.node[i];
  const double pieces = std::ceil(turn.tail<3>().cwiseAbs().sum() / kPieceTurn);
  return static_cast<std::size_t>(std::clamp(pieces, 1.0, kMostPieces));
}

class Cutter {
 public:
  Cutter(Path path, std::size_t pieces) : in_(std::move(path)) {
    out_.arcs = in_.arcs;
    out_.splines = std::move(in_.splines);
    out_.spline_pieces = std::move(in_.spline_pieces);
    out_.corner_blends = std::move(in_.corner_blends);
    out_.curve_blends = std::move(in_.curve_blends);
    out_.tellings = in_.tellings;
    out_.turns = in_.turns;
    out_.out_of_plane = in_.out_of_plane;
    for (auto* column : {&out_.move, &out_.detail}) column->reserve(pieces);
    out_.kind.reserve(pieces);
    out_.length.reserve(pieces);
    out_.node.reserve(pieces + 1);
    out_.node.push_back(in_.node.front());
    place_.reserve(in_.size() + 1);
  }

  Path run() {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      place_.push_back(static_cast<std::uint32_t>(out_.size()));
      add(i, pieces_of(in_, i));
    }
    place_.push_back(static_cast<std::uint32_t>(out_.size()));
    for (Path::Pause pause : in_.pauses) {
      pause.node = place_[pause.node];
      out_.pauses.push_back(pause);
    }
    for (Path::Telling& telling : out_.tellings) telling.node = place_[telling.node];
    for (const Path::Handover& h : in_.handovers) hand_over(h);
    out_.position = NodePositions(out_.length);
    return std::move(out_);
  }

 private:
  void add(std::size_t i, std::size_t pieces) {
    const double length = in_.length[i], step = length / static_cast<double>(pieces);
    for (std::size_t k = 0; k < pieces; ++k) {
      out_.kind.push_back(in_.kind[i]);
      if (!in_.turn.empty()) out_.turn.push_back(in_.turn[i]);
      out_.move.push_back(in_.move[i]);
      out_.length.push_back(pieces == 1 ? length : step);
      out_.detail.push_back(pieces > 1 && in_.kind[i] == SegmentKind::arc ? part_of(i, k, pieces) : in_.detail[i]);
      const double s = static_cast<double>(k + 1) * step;
      // The node behind it is told as what follows is.
      out_.node.push_back(k + 1 == pieces ? in_.node[i + 1] : point_at(in_, i, s));
    }
  }

  std::uint32_t part_of(std::size_t i, std::size_t k, std::size_t pieces) {
    const double step = in_.length[i] / static_cast<double>(pieces);
    const double begin = static_cast<double>(k) * step, end = k + 1 == pieces ? in_.length[i] : begin + step;
    out_.arcs.push_back(part_of_arc(in_.arcs[in_.detail[i]], in_.length[i], begin, end));
    return static_cast<std::uint32_t>(out_.arcs.size() - 1);
  }

  void hand_over(const Path::Handover& h) {
    const std::size_t first = place_[h.segment], pieces = place_[h.segment + 1] - first;
    const double step = in_.length[h.segment] / static_cast<double>(pieces);
    const auto k = std::min(static_cast<std::size_t>(h.at / step), pieces - 1);
    out_.handovers.push_back({static_cast<std::uint32_t>(first + k), h.move, h.at - static_cast<double>(k) * step});
    // The pieces behind begin under it.
    for (std::size_t later = first + k + 1; later < first + pieces; ++later) out_.move[later] = h.move;
  }

  Path in_, out_;
  std::vector<std::uint32_t> place_;  ///< of each old node among the new ones
};

}  // namespace

Path cut_for_axes(Path path) {
  std::size_t pieces = 0;
  if (path.tellings.empty()) return path;
  for (std::size_t i = 0; i < path.size(); ++i) pieces += pieces_of(path, i);
  if (pieces == path.size()) return path;
  return Cutter(std::move(path), pieces).run();
}

}  // namespace toolpace
