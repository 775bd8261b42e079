#include "toolpace/path/build_path.h"

#include <cmath>

#include "toolpace/path/turn_tool.h"

namespace toolpace {
namespace {

class Builder {
 public:
  Builder(const Moves& moves, double tool_change) : moves_(moves), tool_change_(tool_change) {
    const std::size_t n = moves.size();
    path_.kind.reserve(n);
    path_.length.reserve(n);
    path_.move.reserve(n);
    path_.detail.reserve(n);
    path_.node.reserve(n + 1);
    path_.node.push_back(moves.start);
  }

  void add(std::size_t row) {
    if (moves_.has_tip() && moves_.chain_of(row) != chain_) tell_anew(row);
    switch (moves_.kind[row]) {
      case MoveKind::rapid:
      case MoveKind::feed: add_line(row); break;
      case MoveKind::arc: add_arc(row); break;
      case MoveKind::spline: add_spline(row); break;
      case MoveKind::probe:
      case MoveKind::tap:
        add_line(row);
        add_pause(row, 0.0);
        break;
      case MoveKind::dwell: add_pause(row, moves_.dwells[moves_.detail[row]]); break;
      case MoveKind::tool: add_pause(row, tool_change_); break;
      case MoveKind::stop:
      case MoveKind::end: add_pause(row, 0.0); break;
    }
  }

  Path finish() {
    // Where no motion follows nothing is told anew.
    if (auto& all = path_.tellings; !all.empty() && path_.size() > 0 && all.back().node == path_.size()) {
      path_.node.back() = all.back().before;
      all.pop_back();
    }
    path_.position = NodePositions(path_.length);
    return std::move(path_);
  }

 private:
  /// From this row on about another tip. Controllers stop there.
  void tell_anew(std::size_t row) {
    const auto node = static_cast<std::uint32_t>(path_.size());
    auto& all = path_.tellings;
    if (all.empty() || all.back().node != node) {
      all.push_back({node, {}, path_.node.back()});
      add_pause(row, 0.0);
    }
    path_.node.back() = told_about(moves_.chains[moves_.chain_of(row)], moves_.chains[chain_], path_.node.back());
    chain_ = moves_.chain_of(row);
    all.back().chain = moves_.chains[chain_];
  }

  void add_segment(SegmentKind kind, std::size_t row, double length, std::uint32_t detail, const AxisVector& end) {
    path_.kind.push_back(kind);
    path_.length.push_back(length);
    path_.move.push_back(static_cast<std::uint32_t>(row));
    path_.detail.push_back(detail);
    path_.node.push_back(end);
  }

  void add_line(std::size_t row) {
    const AxisVector change = moves_.end[row] - path_.node.back();
    double length = Metric::along(false).norm(change);
    AxisVector end = moves_.end[row];
    // Rounding of a work offset may leave a trace of X, Y, Z in a move of rotary axes alone.
    const double trace = 1e-13 * end.head<3>().norm();
    if (length <= trace) {
      length = Metric::along(true).norm(change);
      end.head<3>() = path_.node.back().head<3>();
    }
    if (length > 0) add_segment(SegmentKind::line, row, length, kNoDetail, end);
  }

  void add_arc(std::size_t row) {
    const ArcCurve arc = make_arc(path_.node.back(), moves_.end[row], moves_.arcs[moves_.detail[row]]);
    const double length = arc_length(arc);
    if (!(length > 0)) return add_line(row);
    path_.arcs.push_back(arc);
    add_segment(SegmentKind::arc, row, length, static_cast<std::uint32_t>(path_.arcs.size() - 1), moves_.end[row]);
  }

  void add_spline(std::size_t row) {
    const auto index = static_cast<std::uint32_t>(path_.splines.size());
    path_.splines.push_back(make_spline(path_.node.back(), moves_.end[row], moves_.splines[moves_.detail[row]]));
    const SplineCurve& curve = path_.splines.back();
    const auto pieces = cut_spline(curve, index);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const bool last = k + 1 == pieces.size();
      path_.spline_pieces.push_back(pieces[k]);
      add_segment(SegmentKind::spline, row, piece_length(curve, pieces[k].begin, pieces[k].end),
                  static_cast<std::uint32_t>(path_.spline_pieces.size() - 1),
                  last ? moves_.end[row] : spline_point(curve, pieces[k].end));
    }
    if (pieces.empty()) add_line(row);
  }

  void add_pause(std::size_t row, double duration) {
    path_.pauses.push_back({static_cast<std::uint32_t>(path_.size()), static_cast<std::uint32_t>(row), duration});
  }

  const Moves& moves_;
  double tool_change_;
  std::uint16_t chain_ = 0;  ///< of the row before
  Path path_;
};

Error not_finite(const Moves& moves, std::size_t row) {
  return {ErrorKind::input,
          "path-not-finite",
          "a coordinate is not a finite number",
          "check the numbers of this line",
          {moves.files.empty() ? std::string() : moves.files[moves.file[row]], moves.line[row], 0},
          {}};
}

}  // namespace

Result<Path> build_path(const Moves& moves, double tool_change, const Monitor& monitor) {
  Builder builder(moves, tool_change);
  for (std::size_t row = 0; row < moves.size(); ++row) {
    if (!moves.end[row].allFinite()) return tl::unexpected(not_finite(moves, row));
    if (row % kReportEvery == 0) {
      if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      monitor.report(static_cast<double>(row) / static_cast<double>(moves.size()));
    }
    builder.add(row);
  }
  return turn_tool(builder.finish());
}

}  // namespace toolpace
