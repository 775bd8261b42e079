#include "toolpace/nc/motion/lathe_roughing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace toolpace::nc {
namespace {

// As LinuxCNC, in the program's unit of length.
constexpr double kNear = 1e-6;
constexpr double kShortArc = 1e-3;  // shorter remains of climbing arcs are left out

// Where a level crosses an element: at most twice, the way forward first.
struct Crossings {
  double at[2] = {};
  int count = 0;
  void add(double x) { at[count++] = x; }
  bool empty() const { return count == 0; }
  double front() const { return at[0]; }
  double back() const { return at[count - 1]; }
};

class Rougher {
 public:
  Rougher(const LatheProfile& profile, const Roughing& roughing, std::vector<LatheMove>& moves, WorkBudget& budget)
      : elements_(profile.elements()),
        roughing_(roughing),
        moves_(moves),
        budget_(budget),
        near_(kNear * profile.unit()),
        short_arc_(kShortArc * profile.unit()),
        tool_(elements_.front().start),
        step_(std::max(roughing.step, 2.0 * near_)) {}

  /// @return false if it would not end
  bool run();

 private:
  bool is_stopped() const { return budget_.left() == 0 || moves_.size() >= kMostLatheMoves; }
  const ContourElement& here() const { return elements_[at_]; }
  double first_level() const { return elements_.front().start.y - (roughing_.first_pass_is_deep ? step_ : 0.0); }

  void go(MoveKind kind, Point end);
  void go_around(const ContourElement& arc, Point end);
  Crossings crossings(const ContourElement& element, double level) const;

  void skip_first_pocket();
  bool clear_pocket();
  bool cut_level();
  void pass(double far);
  bool dive(double level);
  bool dive_line(const ContourElement& line, double level);
  bool dive_arc(const ContourElement& arc, double level);
  bool climb(const ContourElement& element);
  void climb_from_level(const ContourElement& element);
  bool climb_to_next_pocket();
  Point crest_of(const ContourElement& arc) const;

  const std::vector<ContourElement>& elements_;
  const Roughing& roughing_;
  std::vector<LatheMove>& moves_;
  WorkBudget& budget_;
  double near_, short_arc_;
  Point tool_;
  double step_;
  std::size_t at_ = 0;                ///< the element that the tool is on
  double level_ = 0.0;                ///< of the pass to come
  std::optional<double> pocket_top_;  ///< levels of later_pockets count from here
};

void Rougher::go(MoveKind kind, Point end) {
  if (end.x != tool_.x || end.y != tool_.y) moves_.push_back({kind, end, {}, 0});
  tool_ = end;
}

void Rougher::go_around(const ContourElement& arc, Point end) {
  if (norm(end - tool_) > near_) moves_.push_back({MoveKind::arc, end, arc.centre, arc.turn});
  tool_ = end;
}

Crossings Rougher::crossings(const ContourElement& e, double level) const {
  Crossings found;
  if (e.turn == 0) {
    const auto [low, high] = std::minmax(e.start.y, e.end.y);
    if (low > level + near_ || high < level - near_) return found;
    if (high - low < near_) {
      found.add(e.start.x);
      found.add(e.end.x);
    } else {
      found.add(e.start.x + (level - e.start.y) / (e.end.y - e.start.y) * (e.end.x - e.start.x));
    }
    return found;
  }
  const double radius = norm(e.start - e.centre), off = level - e.centre.y;
  const double square = (radius - off) * (radius + off);
  if (square < -near_) return found;
  const double half = std::sqrt(std::max(0.0, square));
  const double sense = e.turn > 0 ? 1.0 : -1.0;
  for (const double beside : {half, -half}) {
    const Point p{beside, off};
    const bool within = sense * cross(e.start - e.centre, p) >= -near_ && sense * cross(e.end - e.centre, p) <= near_;
    if (within) found.add(e.centre.x + beside);
  }
  return found;
}

// Follows the contour down to `level`, or to the end of the element. @return false where it leads up from here
bool Rougher::dive(double level) { return here().turn == 0 ? dive_line(here(), level) : dive_arc(here(), level); }

bool Rougher::dive_line(const ContourElement& line, double level) {
  if (line.start.y <= line.end.y + near_) return false;
  const Crossings found = level < line.end.y ? Crossings{} : crossings(line, level);
  const Point end = found.empty() ? line.end : Point{found.front(), level};
  go(at_ == 0 ? MoveKind::rapid : MoveKind::feed, end);
  return true;
}

bool Rougher::dive_arc(const ContourElement& arc, double level) {
  if (tool_.x - arc.end.x <= near_) {
    tool_ = arc.end;
    return true;
  }
  Crossings found = crossings(arc, level);
  if (found.empty()) found = crossings(arc, level - near_);
  if (arc.turn > 0) {
    if (tool_.x - near_ > arc.centre.x) return false;
    const bool ends_above = found.empty() || found.back() > arc.centre.x;
    go_around(arc, ends_above ? arc.end : Point{found.back(), level});
    return true;
  }
  if (tool_.x <= arc.centre.x) return false;
  if (found.empty()) {
    go_around(arc, arc.end);
  } else if (found.front() >= arc.centre.x) {
    go_around(arc, {found.front(), level});
  }  // else the level is above where the arc begins: the next one may not be
  return true;
}

Point Rougher::crest_of(const ContourElement& arc) const {
  if (arc.end.x >= arc.centre.x) return arc.end;
  return {arc.centre.x, arc.centre.y + norm(arc.start - arc.centre)};
}

// Follows an element up. @return false where a pocket begins on it
bool Rougher::climb(const ContourElement& e) {
  if (e.turn == 0) {
    if (e.end.y + near_ < e.start.y) return false;
    go(MoveKind::feed, e.end);
    return true;
  }
  const bool over = e.turn > 0;
  if (over ? tool_.x < e.centre.x : tool_.x > e.centre.x) return false;
  const Point end = over ? crest_of(e) : e.end;
  if (norm(tool_ - end) > short_arc_) go_around(e, end);
  tool_ = end;
  return !over;
}

// Follows a rising element from the tool's level on, over what is left standing before it.
void Rougher::climb_from_level(const ContourElement& e) {
  if (e.turn == 0 && e.end.y < e.start.y) return;
  const Crossings found = crossings(e, tool_.y);
  if (found.empty()) return;
  if (e.turn == 0) {
    go(MoveKind::feed, {found.front(), tool_.y});
    go(MoveKind::feed, e.end);
    return;
  }
  const bool over = e.turn > 0;
  if (over ? found.front() < e.centre.x : found.back() > e.centre.x) return;
  go(MoveKind::feed, {over ? found.front() : found.back(), tool_.y});
  const Point end = over ? crest_of(e) : e.end;
  if (norm(tool_ - end) > short_arc_) go_around(e, end);
  tool_ = end;
}

// Cuts at the tool's level up to `far`, and comes back above what it has cut.
void Rougher::pass(double far) {
  const Point begin = tool_;
  const double way = begin.x - far;
  const double escape = std::min(roughing_.retract, way / 2.0);
  go(MoveKind::feed, {far, begin.y});
  go(MoveKind::rapid, {far + escape, begin.y + escape});
  go(MoveKind::rapid, {begin.x - escape, begin.y + escape});
  go(at_ == 0 ? MoveKind::rapid : MoveKind::feed, begin);
}

// @return false if the tool went on to another element instead
bool Rougher::cut_level() {
  for (std::size_t i = at_; i < elements_.size() && budget_.spend(); ++i) {
    const Crossings found = crossings(elements_[i], tool_.y);
    if (found.empty()) continue;
    const double far = i != at_ ? found.front() : found.back();
    if (far - near_ > tool_.x) continue;
    if (tool_.x - far >= near_) {
      pass(far);
      return true;
    }
    if (i == at_) continue;  // the descending element itself, where the tool stands
    if (norm(tool_ - elements_[i].start) >= near_) return true;
    at_ = i;
    return false;
  }
  return true;
}

// G71.2: down into what is open from the start, without cutting it level by level.
void Rougher::skip_first_pocket() {
  while (at_ < elements_.size() && dive(-std::numeric_limits<double>::max())) ++at_;
}

// Follows the contour up to where it leads down again. @return false at its end
bool Rougher::climb_to_next_pocket() {
  for (; at_ < elements_.size() && budget_.spend(); ++at_) {
    if (climb(here())) continue;
    if (roughing_.part == RoughingPart::later_pockets && (!pocket_top_ || tool_.y > *pocket_top_)) {
      pocket_top_ = tool_.y;
    }
    return true;
  }
  return false;
}

// @return true if another pocket follows
bool Rougher::clear_pocket() {
  level_ = pocket_top_.value_or(first_level());
  while (at_ < elements_.size() && budget_.spend() && !is_stopped()) {
    if (level_ - near_ > tool_.y) level_ -= std::ceil((level_ - near_ - tool_.y) / step_) * step_;
    if (!dive(level_)) {
      if (roughing_.part != RoughingPart::first_pocket) return climb_to_next_pocket();
      for (; at_ < elements_.size(); ++at_) climb_from_level(here());
      return false;
    }
    if (std::fabs(tool_.y - level_) > near_) {
      ++at_;  // the element ends above the level
    } else if (cut_level()) {
      level_ -= step_;
    }
  }
  return false;
}

bool Rougher::run() {
  if (roughing_.part == RoughingPart::later_pockets) skip_first_pocket();
  while (clear_pocket() && !is_stopped()) {
  }
  return !is_stopped();
}

}  // namespace

bool rough(const LatheProfile& profile, const Roughing& roughing, std::vector<LatheMove>& moves, WorkBudget& budget,
           FaultSink& faults) {
  if (Rougher(profile, roughing, moves, budget).run()) return true;
  return faults.fail("lathe-too-many-passes", "the cycle would make too many passes",
                     "give a larger step I, or a simpler contour");
}

}  // namespace toolpace::nc
