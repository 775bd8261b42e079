#include "toolpace/sample/chord_error.h"

#include <algorithm>

namespace toolpace {

void ChordErrorMeter::compare(const AxisVector& on_path, const AxisVector& begin, const AxisVector& end) {
  const Eigen::Vector3d chord = (end - begin).head<3>(), d = (on_path - begin).head<3>();
  const double length = chord.squaredNorm();
  const double share = length > 0 ? std::clamp(chord.dot(d) / length, 0.0, 1.0) : 0.0;
  largest_ = std::max(largest_, (d - share * chord).norm());
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
