#include "toolpace/rewrite/write_run.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

namespace toolpace::detail::rewrite {
namespace {

/// 1 of lines, 2 and 3 of arcs.
int motion_of_row(const Moves& moves, std::size_t row) {
  if (moves.kind[row] != MoveKind::arc) return 1;
  const ArcDetail& arc = moves.arcs[moves.detail[row]];
  const Eigen::Vector3d normal = arc.normal;
  return arc.sweep * normal.sum() < 0.0 ? 2 : 3;
}

/// The same number without what says nothing: a plus, zeros at the end.
std::string shortened(std::string_view number, bool keeps_point) {
  if (number.front() == '+') number.remove_prefix(1);
  if (number.find('.') == std::string_view::npos) return std::string(number);
  number = number.substr(0, number.find_last_not_of('0') + 1);
  if (number.back() == '.' && !keeps_point) number.remove_suffix(1);
  if (number.find_first_of("123456789") == std::string_view::npos) return keeps_point ? "0." : "0";
  return std::string(number);
}

class RunWriter {
 public:
  RunWriter(const ProgramLines& lines, const Moves& moves, const Edit& edit, bool keeps_points, Composed& out)
      : lines_(lines), moves_(moves), edit_(edit), keeps_points_(keeps_points), out_(out), plane_(edit.run.plane) {
    const auto first = plain_line(lines.content(edit.run.line));
    gap_ = first->is_spaced ? " " : "";
    case_ = first->is_lower ? 'a' - 'A' : 0;
    if (first->motion == 0) motion_ = motion_of_row(moves, edit.run.row);
    if (first->feed.empty() && edit.plans_feeds) feed_ = edit.stretches.front().spans.front().programmed;
  }

  void write(std::size_t number) {
    origin_.edit = number;
    for (origin_.stretch = 0; origin_.stretch < edit_.stretches.size(); ++origin_.stretch) {
      const std::vector<Span>& spans = edit_.stretches[origin_.stretch].spans;
      for (origin_.span = 0; origin_.span < spans.size(); ++origin_.span) write(spans[origin_.span]);
    }
    restore();
  }

 private:
  void write(const Span& span) {
    const auto line = plain_line(lines_.content(edit_.run.line + span.last - 1));
    if (span.kind == Span::Kind::kept) {
      keep(span, *line);
    } else {
      write_span(span, line->label, span.last == edit_.run.count);
    }
  }

  std::size_t line_of(std::size_t row) const { return edit_.run.line + row; }

  void add(std::string_view word_letter, std::string_view number) {
    if (!block_.empty()) block_ += gap_;
    for (const char c : word_letter) block_ += static_cast<char>(c + case_);
    block_ += number;
  }
  void add_code(int code) { add("G", std::to_string(code)); }

  void end_line(std::string_view label, std::string_view ending) {
    if (!label.empty()) block_.insert(0, std::string(label).append(gap_));
    if (!out_.text.empty() && out_.text.back() != '\n') out_.text += '\n';
    out_.text += block_;
    out_.text += ending;
    block_.clear();
    out_.origin.push_back(origin_);
  }

  /// A row as it was written, with what has to stand before it.
  void keep(const Span& span, const PlainLine& line) {
    const std::size_t row = edit_.run.row + span.first;
    const int needed = motion_of_row(moves_, row);
    const bool in_plane = needed == 1 || plane_ == edit_.run.plane;
    const std::string_view content = lines_.content(line_of(span.first));
    if (in_plane && (line.motion != 0 || motion_ == needed)) {
      block_ = edit_.plans_feeds ? without_feed(content, line) : std::string(content);
      if (edit_.plans_feeds) add_planned_feed(span);
      end_line({}, lines_.ending(line_of(span.first)));
    } else {
      if (!in_plane) add_code(plane_ = edit_.run.plane);
      if (line.motion == 0) add_code(needed);
      const std::size_t label = line.label.empty() ? 0 : content.find(line.label) + line.label.size();
      const std::string whole = edit_.plans_feeds ? without_feed(content, line) : std::string(content);
      const std::string_view rest = std::string_view(whole).substr(label);
      block_.append(gap_).append(rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size())));
      if (edit_.plans_feeds) add_planned_feed(span);
      end_line(line.label, lines_.ending(line_of(span.first)));
    }
    motion_ = needed;
  }

  void write_span(const Span& span, std::string_view label, bool is_last) {
    const bool is_arc = span.kind != Span::Kind::line;
    if (span.kind == Span::Kind::biarc) write_joint(span);
    const FittedArc& arc = span.kind == Span::Kind::biarc ? span.second : span.arc;
    const bool is_round = is_arc && arc.turns > 0;
    add_codes(is_round, arc);
    if (!is_round && is_last && plane_ != edit_.run.plane) add_code(plane_ = edit_.run.plane);
    add_end(span);
    if (is_round) add_centre(arc);
    if (span.kind != Span::Kind::biarc) add_feed(span);
    end_line(label, lines_.ending(line_of(span.last - 1)));
  }

  void add_codes(bool is_round, const FittedArc& arc) {
    const int needed = !is_round ? 1 : arc.clockwise ? 2 : 3;
    if (is_round && arc.plane != plane_) add_code(plane_ = arc.plane);
    if (needed != motion_) add_code(motion_ = needed);
  }

  /// The first block of a biarc.
  void write_joint(const Span& span) {
    add_codes(span.arc.turns > 0, span.arc);
    const Eigen::Vector3d from = moves_.begin_of(edit_.run.row + span.first).head<3>();
    const Eigen::Index normal = PlaneOfArcs(span.arc.plane).normal;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (axis == normal && span.joint[axis] == from[axis]) continue;
      const double place = (span.joint[axis] - edit_.run.offset[axis]) / edit_.run.unit;
      add(std::string_view("XYZ").substr(static_cast<std::size_t>(axis), 1),
          shortened(fmt::format("{:.{}f}", place, edit_.decimals), keeps_points_));
    }
    if (span.arc.turns > 0) add_centre(span.arc);
    add_feed(span);
    end_line({}, lines_.ending(line_of(span.last - 1)));
  }

  /// The words of axes that the span moves, and of an arc both of its plane; at least one.
  void add_end(const Span& span) {
    const std::size_t row = edit_.run.row;
    const AxisVector &from = moves_.begin_of(row + span.first), &to = moves_.end[row + span.last - 1];
    const bool is_arc = span.kind != Span::Kind::line;
    const Eigen::Index normal = !is_arc ? 3 : PlaneOfArcs(span.arc.plane).normal;
    bool any = false;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const bool by_joint = span.kind == Span::Kind::biarc && span.joint[axis] != from[axis];
      if (from[axis] == to[axis] && !by_joint && (!is_arc || axis == normal)) continue;
      any = add_axis(span, axis) || any;
    }
    for (Eigen::Index axis = 0; axis < 3 && !any; ++axis) any = add_axis(span, axis);
  }

  /// As it is written last up to the span's end.
  bool add_axis(const Span& span, Eigen::Index axis) {
    for (std::size_t k = span.last; k-- > edit_.run.named[static_cast<std::size_t>(axis)];) {
      const auto line = plain_line(lines_.content(line_of(k)));
      const std::string_view number = line->axis[static_cast<std::size_t>(axis)];
      if (number.empty()) continue;
      add(std::string_view("XYZ").substr(static_cast<std::size_t>(axis), 1), shortened(number, keeps_points_));
      return true;
    }
    return false;
  }

  void add_centre(const FittedArc& arc) {
    const char first = arc.plane == 17 ? 'I' : arc.plane == 18 ? 'K' : 'J';
    const char second = arc.plane == 17 ? 'J' : arc.plane == 18 ? 'I' : 'K';
    // In the order of letters, as people write them.
    const bool swapped = first > second;
    add_offset(swapped ? second : first, swapped ? arc.j : arc.i);
    add_offset(swapped ? first : second, swapped ? arc.i : arc.j);
    if (arc.turns > 1) add("P", std::to_string(arc.turns));
  }

  void add_offset(char letter, double offset) {
    const std::string number = fmt::format("{:.{}f}", offset / edit_.run.unit, edit_.decimals);
    const std::string text = shortened(number, keeps_points_);
    if (text == "0" || text == "0.") return;
    add(std::string_view(&letter, 1), text);
  }

  /// Where the feed changes with the span, or the run begins: what is written there.
  void add_feed(const Span& span) {
    if (edit_.plans_feeds) return add_planned_feed(span);
    const std::size_t row = edit_.run.row + span.first;
    if (span.first > 0 && moves_.feed[row] == moves_.feed[row - 1]) return;
    const auto line = plain_line(lines_.content(line_of(span.first)));
    if (!line->feed.empty()) add("F", line->feed);
  }

  void add_planned_feed(const Span& span) {
    const double feed = span.feed > 0.0 ? span.feed : span.programmed;
    if (feed == feed_ || !(feed > 0.0)) return;
    feed_ = feed;
    add("F", feed_text(feed));
  }

  std::string feed_text(double feed) const {
    std::string text = fmt::format("{}", feed);
    if (text.find_first_not_of("0123456789.") != std::string::npos) text = fmt::format("{:.9f}", feed);
    return keeps_points_ && text.find('.') == std::string::npos ? text + '.' : text;
  }

  /// N stays where it is.
  static std::string without_feed(std::string_view content, const PlainLine& line) {
    if (line.feed.empty()) return std::string(content);
    const auto number = static_cast<std::size_t>(line.feed.data() - content.data());
    std::size_t begin = content.find_last_of("Ff", number);
    const std::size_t end = number + line.feed.size();
    if (begin > 0 && content[begin - 1] == ' ') --begin;
    return std::string(content.substr(0, begin)).append(content.substr(end));
  }

  /// Lets the lines behind the run find the modal state that they expect.
  void restore() {
    const Run& run = edit_.run;
    const int expected = motion_of_row(moves_, run.row + run.count - 1);
    const bool restores_motion = motion_ != expected && !is_motion_named_from(lines_, run.line + run.count);
    const double feed = edit_.stretches.back().spans.back().programmed;
    const bool restores_feed = edit_.plans_feeds && feed_ != feed;
    if (plane_ == run.plane && !restores_motion && !restores_feed) return;
    if (plane_ != run.plane) add_code(run.plane);
    if (restores_motion) add_code(expected);
    if (restores_feed) add("F", feed_text(feed));
    const std::string_view ending = lines_.ending(run.line + run.count - 1);
    end_line({}, ending.empty() ? "\n" : ending);
  }

  const ProgramLines& lines_;
  const Moves& moves_;
  const Edit& edit_;
  bool keeps_points_;
  Composed& out_;
  int plane_;
  int motion_ = 0;     // modal one in what is written; 0 = not known
  double feed_ = 0.0;  // the same, in the program's units
  Origin origin_;
  std::string_view gap_;
  int case_ = 0;
  std::string block_;
};

}  // namespace

Composed compose(const ProgramLines& lines, const Moves& moves, const std::vector<Edit>& edits, bool keeps_points) {
  Composed out;
  std::size_t line = 1;
  const auto keep_up_to = [&](std::size_t end) {
    for (; line < end; ++line) {
      out.text += lines.whole(line);
      out.origin.push_back({line});
    }
  };
  for (std::size_t k = 0; k < edits.size(); ++k) {
    const Edit& edit = edits[k];
    if (edit.stretches.empty()) continue;
    keep_up_to(edit.run.line);
    RunWriter(lines, moves, edit, keeps_points, out).write(k);
    line += edit.run.count;
  }
  keep_up_to(lines.count() + 1);
  return out;
}

}  // namespace toolpace::detail::rewrite
