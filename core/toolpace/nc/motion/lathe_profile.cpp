#include "toolpace/nc/motion/lathe_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace toolpace::nc {
namespace {

// As LinuxCNC, in the program's unit of length.
constexpr double kSlack = 1e-3;  // an element may go back by as much
constexpr double kOpen = 1e-2;   // wider gaps of corners get an arc
constexpr double kTouchingEnds = 1e-6;

// What limits how far an element can be moved at once.
double size_of(const OffsetElement& e) {
  const double chord = norm(e.start - e.end);
  return e.turn == 0 ? chord : std::min(chord, norm(e.start - e.centre));
}

// Moves an element of a falling contour up, away from the work.
void raise(ContourElement& e, double distance) {
  if (e.turn == 0) {
    const Point up = turned(e.start - e.end, 1.0) * (distance / norm(e.start - e.end));
    e.start = e.start + up;
    e.end = e.end + up;
    return;
  }
  const double radius = norm(e.start - e.centre);
  const double factor = (radius + (e.turn > 0 ? distance : -distance)) / radius;
  e.start = e.centre + (e.start - e.centre) * factor;
  e.end = e.centre + (e.end - e.centre) * factor;
}

// Where neighbours meet, or nearly do: rounded numbers part what is tangent.
std::optional<Point> where_they_meet(const OffsetElement& a, const OffsetElement& b) {
  if (const auto meeting = meeting_of(a, b, b.start)) return meeting;
  if ((a.turn == 0) == (b.turn == 0)) return std::nullopt;
  const OffsetElement& line = a.turn == 0 ? a : b;
  const OffsetElement& arc = a.turn == 0 ? b : a;
  return foot_on_line(line, arc.centre);
}

}  // namespace

LatheProfile::LatheProfile(std::vector<ContourElement> contour, bool facing, double unit)
    : elements_(std::move(contour)), unit_(unit), facing_(facing) {
  if (facing_) {
    for (auto& e : elements_) {
      for (Point* p : {&e.start, &e.end, &e.centre}) *p = turned(*p, -1.0);
    }
  }
  const Point way = elements_.back().end - elements_.front().end;
  if (lies_below(elements_.front().start.y, way.y)) mirror_level();
  if (way.x > 0.0) mirror_along();
}

// The material lies between the contour and the level that the cycle starts at. Where that lies within the contour's own
// levels, it is where the contour leads to.
bool LatheProfile::lies_below(double start, double way) const {
  double lowest = elements_.front().end.y, highest = lowest;
  for (const auto& e : elements_) {
    lowest = std::min(lowest, e.end.y);
    highest = std::max(highest, e.end.y);
  }
  const double slack = kSlack * unit_;
  const bool below = start <= lowest + slack, above = start >= highest - slack;
  return below == above ? way < 0.0 : below;
}

void LatheProfile::mirror_level() {
  mirrors_level_ = !mirrors_level_;
  for (auto& e : elements_) {
    for (Point* p : {&e.start, &e.end, &e.centre}) p->y = -p->y;
    e.turn = -e.turn;
  }
}

void LatheProfile::mirror_along() {
  mirrors_along_ = !mirrors_along_;
  for (auto& e : elements_) {
    for (Point* p : {&e.start, &e.end, &e.centre}) p->x = -p->x;
    e.turn = -e.turn;
  }
}

Point LatheProfile::in_machine(Point p) const {
  if (mirrors_along_) p.x = -p.x;
  if (mirrors_level_) p.y = -p.y;
  return facing_ ? turned(p, 1.0) : p;
}

Point LatheProfile::from_machine(Point difference) const {
  Point p = facing_ ? turned(difference, -1.0) : difference;
  if (mirrors_along_) p.x = -p.x;
  if (mirrors_level_) p.y = -p.y;
  return p;
}

bool LatheProfile::goes_on(const ContourElement& e) const {
  const double slack = kSlack * unit_;
  const double step = e.end.x - e.start.x;
  if (e.turn == 0) return step <= slack;
  const double side = e.turn > 0 ? 1.0 : -1.0;
  return side * (e.start.y - e.centre.y) >= -slack && side * (e.end.y - e.centre.y) >= -slack && step <= -slack;
}

const ContourElement* LatheProfile::find_turning_back() const {
  const auto found =
      std::find_if(elements_.begin() + 1, elements_.end(), [this](const ContourElement& e) { return !goes_on(e); });
  return found == elements_.end() ? nullptr : &*found;
}

void LatheProfile::start_above() {
  ContourElement& entry = elements_.front();
  entry.start.x = std::max(entry.start.x, entry.end.x);
}

void LatheProfile::shift(Point by) {
  for (auto& e : elements_) {
    for (Point* p : {&e.start, &e.end, &e.centre}) *p = *p + by;
  }
}

void LatheProfile::close() {
  const Point end = elements_.back().end;
  const double level = elements_.front().start.y;
  if (end.y < level) elements_.push_back({{end, {end.x, level}, {}, 0}, elements_.back().line});
}

bool LatheProfile::widen(double distance, WorkBudget& budget, FaultSink& faults) {
  const Point entry = elements_.front().end - elements_.front().start;
  const Point whole = elements_.back().start - elements_.front().start;
  if (cross(whole, entry) < 0.0) distance = -distance;
  std::vector<ContourElement> contour(elements_.begin() + 1, elements_.end());
  double left = std::fabs(distance);
  while (left > 0.0) {
    // Small steps, so that no element turns inside out before it is dropped.
    double step = left;
    for (const auto& e : contour) step = std::min(step, size_of(e) / 2.0);
    if (!widen_step(contour, std::copysign(step, distance), budget)) {
      return faults.fail("lathe-allowance",
                         fmt::format("nothing is left of the contour at a distance of {:g} mm", std::fabs(distance)),
                         "give a smaller allowance D (of G70 also E)");
    }
    left -= step;
  }
  for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
    const Point middle = (contour[i].end + contour[i + 1].start) * 0.5;
    contour[i].end = contour[i + 1].start = middle;
  }
  elements_.front().end = contour.front().start;
  elements_.resize(1);
  elements_.insert(elements_.end(), contour.begin(), contour.end());
  return true;
}

bool LatheProfile::widen_step(std::vector<ContourElement>& contour, double step, WorkBudget& budget) const {
  if (step == 0.0 || !budget.spend(contour.size())) return false;
  for (auto& e : contour) raise(e, step);
  std::erase_if(contour, [this](const ContourElement& e) { return size_of(e) < kVanishing * unit_; });
  fill_corners(contour, step);
  return trim(contour, budget) && !contour.empty();
}

void LatheProfile::fill_corners(std::vector<ContourElement>& contour, double step) const {
  std::vector<ContourElement> filled;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    filled.push_back(contour[i]);
    if (i + 1 == contour.size() || !(contour[i].end.x - contour[i + 1].start.x > kOpen * unit_)) continue;
    ContourElement before = contour[i], after = contour[i + 1];
    raise(before, -step);
    raise(after, -step);
    const Point corner = (before.end + after.start) * 0.5;
    filled.push_back({{contour[i].end, contour[i + 1].start, corner, step > 0.0 ? 1 : -1}, contour[i].line});
  }
  contour = std::move(filled);
}

// Cuts neighbours off where they meet, and drops what the cuts have turned round.
bool LatheProfile::trim(std::vector<ContourElement>& contour, WorkBudget& budget) const {
  const auto drop = [&](std::size_t i) { contour.erase(contour.begin() + static_cast<std::ptrdiff_t>(i)); };
  for (std::size_t i = 0; i + 1 < contour.size();) {
    if (!budget.spend()) return false;
    if (!goes_on(contour[i]) || size_of(contour[i]) < kVanishing * unit_) {
      const bool before_is_smaller = i > 0 && size_of(contour[i - 1]) <= size_of(contour[i]);
      if (!budget.spend(contour.size() / 16)) return false;
      drop(before_is_smaller ? i - 1 : i);
      i = i > 2 ? i - 2 : 0;
      continue;
    }
    ContourElement& a = contour[i];
    ContourElement& b = contour[i + 1];
    ++i;
    const bool lines = a.turn == 0 && b.turn == 0;
    if (!lines && norm(a.end - b.start) < kTouchingEnds * unit_) continue;
    if (const auto meeting = where_they_meet(a, b)) a.end = b.start = *meeting;
  }
  return true;
}

}  // namespace toolpace::nc
