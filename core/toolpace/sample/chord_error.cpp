#include "toolpace/sample/chord_error.h"

#include <algorithm>

namespace toolpace {
namespace {

constexpr Metric kApart = Metric::apart();
constexpr double kRounding = 1e-12;  // of lengths, squared

double squared(double x) { return x * x; }

bool turns_anywhere(const Path& path) {
  const auto turns = [&](const AxisVector& a, const AxisVector& b) {
    return kApart.squared_norm(a - b) != Metric::along(false).squared_norm(a - b);
  };
  return std::adjacent_find(path.node.begin(), path.node.end(), turns) != path.node.end();
}

double distance_to_chord(const AxisVector& point, const AxisVector& begin, const AxisVector& end) {
  const AxisVector chord = end - begin, d = point - begin;
  const double square = kApart.squared_norm(chord);
  const double share = square > 0 ? std::clamp(kApart.dot(chord, d) / square, 0.0, 1.0) : 0.0;
  return kApart.norm(d - share * chord);
}

}  // namespace

ChordErrorMeter::ChordErrorMeter(const Path& path)
    : path_(path), curve_(path), turns_(!path.tellings.empty() || turns_anywhere(path)) {}

void ChordErrorMeter::compare(const AxisVector& on_path, const AxisVector& place) {
  const double distance =
      middle_ ? std::min(distance_to_chord(on_path, point_, *middle_), distance_to_chord(on_path, *middle_, place))
              : distance_to_chord(on_path, point_, place);
  largest_ = std::max(largest_, distance);
}

void ChordErrorMeter::compare_curve(std::size_t segment, double begin, double end, const AxisVector& place) {
  const bool is_straight = middle_ ? curve_.is_straight(segment) : is_even_line(path_, segment);
  if (!is_straight && end > begin) compare(point_at(path_, segment, (begin + end) / 2), place);
}

void ChordErrorMeter::find_middle(std::size_t segment, const AxisVector& place) {
  middle_.reset();
  const Chain* const chain = path_.chain_of(segment);
  if (chain == nullptr || chain != path_.chain_of(segment_)) return;
  middle_ = told_about(*chain, {}, (curve_.axes_of(segment_, point_) + curve_.axes_of(segment, place)) / 2);
}

double ChordErrorMeter::length_to(std::size_t segment, double s) const {
  if (segment == segment_) return s - s_;
  double length = path_.length[segment_] - s_ + s;
  for (std::size_t i = segment_ + 1; i < segment; ++i) length += path_.length[i];
  return length;
}

bool ChordErrorMeter::may_be_larger(std::size_t segment, double s, const AxisVector& place) const {
  if (turns_) return true;
  const double length = squared(length_to(segment, s));
  return length * (1 + kRounding) - kApart.squared_norm(place - point_) > 4 * squared(largest_);
}

void ChordErrorMeter::add(std::size_t segment, double s, const AxisVector& place) {
  if (started_ && may_be_larger(segment, s, place)) {
    if (!path_.tellings.empty()) find_middle(segment, place);
    if (segment == segment_) {
      compare_curve(segment, s_, s, place);
    } else if (path_.chain_of(segment) == path_.chain_of(segment_)) {
      compare_curve(segment_, s_, path_.length[segment_], place);
      for (std::size_t i = segment_ + 1; i <= segment; ++i) {
        compare(path_.node[i], place);
        compare_curve(i, 0.0, i == segment ? s : path_.length[i], place);
      }
    }
  }
  started_ = true;
  segment_ = segment;
  s_ = s;
  point_ = place;
}

}  // namespace toolpace
