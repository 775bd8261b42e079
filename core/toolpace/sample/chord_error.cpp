#include "toolpace/sample/chord_error.h"

#include <algorithm>

namespace toolpace {

void ChordErrorMeter::compare(const AxisVector& on_path, const AxisVector& begin, const AxisVector& end) {
  constexpr Metric kApart = Metric::apart();
  const AxisVector chord = end - begin, d = on_path - begin;
  const double square = kApart.squared_norm(chord);
  const double share = square > 0 ? std::clamp(kApart.dot(chord, d) / square, 0.0, 1.0) : 0.0;
  largest_ = std::max(largest_, kApart.norm(d - share * chord));
}

void ChordErrorMeter::compare_curve(std::size_t segment, double begin, double end, const AxisVector& from,
                                    const AxisVector& to) {
  if (path_.kind[segment] != SegmentKind::line && end > begin) {
    compare(point_at(path_, segment, (begin + end) / 2), from, to);
  }
}

void ChordErrorMeter::add(std::size_t segment, double s, const AxisVector& point) {
  if (started_) {
    if (segment == segment_) {
      compare_curve(segment, s_, s, point_, point);
    } else {
      compare_curve(segment_, s_, path_.length[segment_], point_, point);
      for (std::size_t i = segment_ + 1; i <= segment; ++i) {
        compare(path_.node[i], point_, point);
        compare_curve(i, 0.0, i == segment ? s : path_.length[i], point_, point);
      }
    }
  }
  started_ = true;
  segment_ = segment;
  s_ = s;
  point_ = point;
}

}  // namespace toolpace
