/// Whole programs through the interpreter, in every dialect. The first byte chooses dialect and switches.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "toolpace/nc/reader.h"

namespace {

using namespace toolpace;

ReadOptions small_bounds() {
  ReadOptions options;
  options.limits = {.call_depth = 20, .loop_turns = 2000, .blocks = 20000, .lines = 20000};
  return options;
}

/// What planning relies on: columns of one length, finite rows, details that exist.
void check(const Moves& m) {
  const std::size_t n = m.size();
  if (m.line.size() != n || m.file.size() != n || m.mode.size() != n || m.detail.size() != n || m.end.size() != n ||
      m.feed.size() != n) {
    std::abort();
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!m.end[i].allFinite() || !(m.feed[i] >= 0.0) || m.mode[i] >= m.modes.size() || m.file[i] >= m.files.size())
      std::abort();
    if (m.kind[i] == MoveKind::arc && m.detail[i] >= m.arcs.size()) std::abort();
    if (m.kind[i] == MoveKind::spline && m.detail[i] >= m.splines.size()) std::abort();
    if (m.kind[i] == MoveKind::dwell && m.detail[i] >= m.dwells.size()) std::abort();
    if (!is_motion(m.kind[i]) && m.kind[i] != MoveKind::dwell && m.detail[i] >= m.notes.size()) std::abort();
  }
  for (const MoveMode& mode : m.modes) {
    if (mode.ceiling >= m.ceilings.size()) std::abort();
  }
  for (const MotionCeiling& c : m.ceilings) {
    const bool moves = c.speed.minCoeff() > 0.0 && c.acceleration.minCoeff() > 0.0 && c.path_speed > 0.0 &&
                       c.path_acceleration > 0.0 && c.accuracy >= 0.0 && c.accuracy <= 1.0;
    if (!moves || !(c.corner_speed >= 0.0) || !(c.junction_deviation >= 0.0) || !(c.corner_step.minCoeff() >= 0.0))
      std::abort();
  }
  for (const auto& arc : m.arcs) {
    if (!arc.centre.allFinite() || !Eigen::Vector3d(arc.normal).allFinite() || !std::isfinite(arc.sweep)) std::abort();
  }
  for (const auto& spline : m.splines) {
    if (spline.knots.size() != spline.points.size() + static_cast<std::size_t>(spline.degree) + 1) std::abort();
    if (spline.weights.size() != spline.points.size()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  ReadOptions options = small_bounds();
  const std::size_t dialect = (data[0] & 3u) + 4u * (data[0] >> 4u);
  options.dialect = all_dialects()[dialect % all_dialects().size()];
  options.block_delete = (data[0] & 4u) != 0;
  options.strict = (data[0] & 8u) != 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto reading = read_text(text, "-", options);
  if (reading) check(reading->moves);
  return 0;
}
