#include "toolpace/rewrite/runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "toolpace/nc/state.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr std::uint32_t kNoRow = 0xffffffffu, kManyRows = 0xfffffffeu;
constexpr std::size_t kMostSearch = 200'000'000;  // entries of logs that are out of order, looked at
constexpr double kSame = 1e-9;                    // of a coordinate: what offsets leave of its last digits

/// The row of each line of the program that has exactly one.
std::vector<std::uint32_t> rows_of_lines(const Moves& moves, std::size_t lines) {
  std::vector<std::uint32_t> rows(lines + 1, kNoRow);
  for (std::size_t row = 0; row < moves.size(); ++row) {
    if (moves.file[row] != 0 || moves.line[row] > lines) continue;
    std::uint32_t& known = rows[moves.line[row]];
    known = known == kNoRow ? static_cast<std::uint32_t>(row) : kManyRows;
  }
  return rows;
}

class RunFinder {
 public:
  RunFinder(const ProgramLines& lines, const Reading& reading)
      : lines_(lines), moves_(reading.moves), reading_(reading), needs_points_(counts_integers(reading.dialect)) {
    rows_ = rows_of_lines(moves_, lines.count());
    search_ = is_in_order(moves_) ? 0 : reading.modal.size();
  }

  std::vector<Run> find() {
    for (std::size_t line = 1; line <= lines_.count(); ++line) {
      if (open_ && take(line)) continue;
      close();
      if (begin(line)) take(line);
    }
    close();
    return std::move(runs_);
  }

 private:
  bool is_candidate(std::size_t row) const {
    const MoveKind kind = moves_.kind[row];
    return (kind == MoveKind::feed || kind == MoveKind::arc) && moves_.modes[moves_.mode[row]].feed_mode == 94;
  }

  bool begin(std::size_t line) {
    const std::uint32_t row = rows_[line];
    if (row >= kManyRows || !is_candidate(row) || !plain_line(lines_.content(line))) return false;
    if (searched_ += search_; searched_ > kMostSearch) return false;
    const auto modal = reading_.modal.at(line);
    if (!modal || modal->distance != 900 || modal->arc_distance != 911 || modal->compensation != 400 ||
        modal->lathe_diameter != 80)
      return false;
    open_ = Run{line, 0, row, moves_.modes[moves_.mode[row]].plane, modal->units == 200 ? nc::kMmPerInch : 1.0, {}, {}};
    offset_ = {};
    return true;
  }

  /// Whether the line goes on with the open run; adds it.
  bool take(std::size_t line) {
    const std::size_t row = open_->row + open_->count;
    if (rows_[line] != row || !is_candidate(row) || moves_.mode[row] != moves_.mode[open_->row]) return false;
    const auto plain = plain_line(lines_.content(line));
    if (!plain || (needs_points_ && !plain->has_points)) return false;
    if (plain->has_centre != (moves_.kind[row] == MoveKind::arc)) return false;
    const AxisVector &from = moves_.begin_of(row), &to = moves_.end[row];
    if (from.tail<3>() != to.tail<3>()) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      if (!agrees(plain->axis[i], i, from[axis], to[axis])) return false;
    }
    ++open_->count;
    return true;
  }

  /// Whether an axis went where its word says, but for the same offset as before; or stayed, where there is no word.
  bool agrees(std::string_view word, std::size_t axis, double from, double to) {
    const double near = kSame * std::max(1.0, std::fabs(to));
    if (word.empty()) return std::fabs(to - from) <= near;
    const double offset = to - value_of(word) * open_->unit;
    if (!offset_[axis]) {
      offset_[axis] = open_->offset[static_cast<Eigen::Index>(axis)] = offset;
      open_->named[axis] = static_cast<std::uint32_t>(open_->count);
    }
    return std::fabs(offset - *offset_[axis]) <= near;
  }

  /// What follows may count on G2 or G3 being modal, which no line sets without going round: such an end is left out.
  void close() {
    if (!open_) return;
    std::size_t& count = open_->count;
    while (count >= 2 && moves_.kind[open_->row + count - 1] == MoveKind::arc &&
           !is_motion_named_from(lines_, open_->line + count))
      --count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!offset_[axis]) open_->named[axis] = static_cast<std::uint32_t>(count);
    }
    if (count >= 2) runs_.push_back(*open_);
    open_.reset();
  }

  const ProgramLines& lines_;
  const Moves& moves_;
  const Reading& reading_;
  bool needs_points_;
  std::vector<std::uint32_t> rows_;
  std::size_t search_ = 0, searched_ = 0;
  std::optional<Run> open_;
  std::array<std::optional<double>, 3> offset_;
  std::vector<Run> runs_;
};

}  // namespace

bool counts_integers(Dialect dialect) {
  return dialect == Dialect::fanuc || dialect == Dialect::fanuc_lathe || dialect == Dialect::fanuc_lathe_b ||
         dialect == Dialect::haas;
}

bool is_in_order(const Moves& moves) {
  return moves.files.size() <= 1 && std::is_sorted(moves.line.begin(), moves.line.end());
}

std::vector<Run> find_runs(const ProgramLines& lines, const Reading& reading) {
  return RunFinder(lines, reading).find();
}

}  // namespace toolpace::detail::rewrite
