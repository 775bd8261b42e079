#include "toolpace/nc/move_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "toolpace/base/axis_unit.h"

namespace toolpace::nc {
namespace {

constexpr double kNoMove = 1e-9;  // [mm, deg]: below it an axis stands still, for the choice between mm/min and deg/min

MoveMode make_mode(const Modal& modal, bool exact_path, bool synchronised) {
  MoveMode mode;
  mode.plane = static_cast<std::uint8_t>(modal.plane / 10);
  mode.feed_mode = synchronised ? kSynchronisedFeed : static_cast<std::uint8_t>(modal.feed_mode / 10);
  if (exact_path || modal.path_control == 610) {
    mode.control = PathControl::exact_path;
  } else if (modal.path_control == 611) {
    mode.control = PathControl::exact_stop;
  } else if (modal.tolerance_given) {
    mode.control = PathControl::blend;
    mode.tolerance = modal.path_tolerance;
    mode.naive_tolerance = modal.naive_tolerance;
  }
  return mode;
}

}  // namespace

bool MoveWriter::ModeOrder::operator()(const MoveMode& a, const MoveMode& b) const {
  const auto key = [](const MoveMode& m) {
    return std::tuple(m.control, m.tolerance, m.naive_tolerance, m.plane, m.feed_mode, m.ceiling, m.chain);
  };
  return key(a) < key(b);
}

bool MoveWriter::CeilingOrder::operator()(const MotionCeiling& a, const MotionCeiling& b) const {
  const auto key = [](const MotionCeiling& c) {
    return std::tuple(c.path_speed, c.path_acceleration, c.corner_speed, c.junction_deviation, c.accuracy,
                      c.holds_overrides);
  };
  if (key(a) != key(b)) return key(a) < key(b);
  for (const auto values : {&MotionCeiling::speed, &MotionCeiling::acceleration, &MotionCeiling::corner_step}) {
    const AxisVector &x = a.*values, &y = b.*values;
    if (x != y) return std::lexicographical_compare(x.data(), x.data() + x.size(), y.data(), y.data() + y.size());
  }
  return false;
}

AxisVector machine_vector(const Offsets& offsets, const Position& work) {
  const Position machine = to_machine(offsets, work);
  AxisVector v;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    v[static_cast<Eigen::Index>(i)] = machine[i] * axis_unit(i).size;
  }
  return v;
}

void MoveWriter::set_chain(const Chain& chain) {
  auto& chains = moves_.chains;
  const auto known = std::find(chains.begin(), chains.end(), chain);
  const auto index = static_cast<std::size_t>(known - chains.begin());
  if (known == chains.end()) {
    if (chains.size() > std::numeric_limits<std::uint16_t>::max()) {
      has_all_modes_ = full_ = true;
      return;
    }
    chains.push_back(chain);
  }
  chain_ = static_cast<std::uint16_t>(index);
}

AxisVector MoveWriter::last_end() const {
  const AxisVector& end = moves_.empty() ? moves_.start : moves_.end.back();
  if (!moves_.has_tip()) return end;
  const std::uint16_t chain = moves_.empty() ? 0 : moves_.modes[moves_.mode.back()].chain;
  return told_about(moves_.chains[chain_], moves_.chains[chain], end);
}

void MoveWriter::set_mode(const Modal& modal, bool exact_path, bool synchronised) {
  MoveMode mode = make_mode(modal, exact_path, synchronised);
  mode.chain = chain_;
  if (!find_ceiling(modal.holds_overrides, mode.ceiling)) {
    has_all_modes_ = full_ = true;
    return;
  }
  auto& modes = moves_.modes;
  if (modes[mode_] == mode) return;
  const auto [known, is_new] = known_modes_.try_emplace(mode, modes.size());
  if (is_new) {
    if (modes.size() > std::numeric_limits<std::uint16_t>::max()) {
      known_modes_.erase(known);
      has_all_modes_ = full_ = true;
      return;
    }
    modes.push_back(mode);
  }
  mode_ = static_cast<std::uint16_t>(known->second);
}

void MoveWriter::set_ceilings(const MotionCeiling& feeding, const MotionCeiling& travelling) {
  ceilings_[0] = feeding;
  ceilings_[1] = travelling;
  for (auto& of_kind : known_) of_kind[0] = of_kind[1] = std::nullopt;
}

// @return false where there are too many
bool MoveWriter::find_ceiling(bool holds_overrides, std::uint16_t& index) {
  std::optional<std::uint16_t>& known = known_[travels_ ? 1 : 0][holds_overrides ? 1 : 0];
  if (!known) {
    MotionCeiling ceiling = ceilings_[travels_ ? 1 : 0];
    ceiling.holds_overrides = holds_overrides;
    auto& all = moves_.ceilings;
    const auto [found, is_new] = known_ceilings_.try_emplace(ceiling, all.size());
    if (is_new && all.size() > std::numeric_limits<std::uint16_t>::max()) {
      known_ceilings_.erase(found);
      return false;
    }
    if (is_new) all.push_back(ceiling);
    known = static_cast<std::uint16_t>(found->second);
  }
  index = *known;
  return true;
}

bool MoveWriter::begin_row() {
  if (!enabled_) return false;
  if (moves_.size() >= most_rows_) full_ = true;
  return !full_;
}

void MoveWriter::append(MoveKind kind, const AxisVector& end, double feed, std::uint32_t detail) {
  if (!(end.cwiseAbs().maxCoeff() <= kFarthest)) {
    too_far_ = true;
    return;
  }
  moves_.kind.push_back(kind);
  moves_.line.push_back(line_);
  moves_.file.push_back(file_);
  moves_.mode.push_back(mode_);
  moves_.detail.push_back(detail);
  moves_.end.push_back(end);
  moves_.feed.push_back(feed);
}

void MoveWriter::line(MoveKind kind, const Offsets& offsets, const Position& end, const Feedrate& feed,
                      std::uint32_t detail) {
  if (!begin_row()) return;
  const AxisVector target = machine_vector(offsets, end);
  double rate = 0.0;
  if (kind != MoveKind::rapid) {
    const AxisVector step = (target - last_end()).cwiseAbs();
    const bool linear = step.head<3>().maxCoeff() > kNoMove;
    const bool angular = step.tail<3>().maxCoeff() > kNoMove * kRadiansPerDegree;
    rate = angular && !linear ? feed.angular * kRadiansPerDegree * kPerMinute : feed.linear * kPerMinute;
  }
  append(kind, target, rate, detail);
}

void MoveWriter::arc(const Offsets& offsets, const Position& end, const ArcDetail& arc, double feed_mm_min) {
  if (!begin_row()) return;
  moves_.arcs.push_back(arc);
  append(MoveKind::arc, machine_vector(offsets, end), feed_mm_min * kPerMinute,
         static_cast<std::uint32_t>(moves_.arcs.size() - 1));
}

void MoveWriter::spline(const Offsets& offsets, const Position& end, SplineDetail spline, double feed_mm_min) {
  if (!begin_row()) return;
  moves_.splines.push_back(std::move(spline));
  append(MoveKind::spline, machine_vector(offsets, end), feed_mm_min * kPerMinute,
         static_cast<std::uint32_t>(moves_.splines.size() - 1));
}

void MoveWriter::dwell(double seconds) {
  if (!begin_row()) return;
  moves_.dwells.push_back(seconds);
  append(MoveKind::dwell, last_end(), 0.0, static_cast<std::uint32_t>(moves_.dwells.size() - 1));
}

void MoveWriter::note(MoveKind kind, std::string text) {
  if (!begin_row()) return;
  moves_.notes.push_back(std::move(text));
  append(kind, last_end(), 0.0, static_cast<std::uint32_t>(moves_.notes.size() - 1));
}

void MoveWriter::truncate(std::size_t first) {
  if (first >= moves_.size()) return;
  moves_.kind.resize(first);
  moves_.line.resize(first);
  moves_.file.resize(first);
  moves_.mode.resize(first);
  moves_.detail.resize(first);
  moves_.end.resize(first);
  moves_.feed.resize(first);
}

}  // namespace toolpace::nc
