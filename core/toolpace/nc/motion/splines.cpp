#include "toolpace/nc/motion/splines.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/motion/spline_length.h"

namespace toolpace::nc {
namespace {

constexpr int kHighestOrder = 20;
constexpr std::size_t kMostControlPoints = 1000000;

// 0 … 0, 1, 2, …, m … m: `order` equal knots at both ends, unit steps between (as LinuxCNC spaces them).
std::vector<double> clamped_knots(std::size_t points, int order) {
  std::vector<double> knots;
  const auto k = static_cast<std::size_t>(order);
  for (std::size_t i = 0; i < points + k; ++i) {
    if (i < k)
      knots.push_back(0.0);
    else if (i < points)
      knots.push_back(static_cast<double>(i - k + 1));
    else
      knots.push_back(static_cast<double>(points - k + 1));
  }
  return knots;
}

Eigen::Vector3d machine_point(const Offsets& offsets, Position at, double x, double y) {
  at[0] = x;
  at[1] = y;
  return machine_vector(offsets, at).head<3>();
}

bool check_spline(Context& context, const Block& block) {
  const State& state = context.state;
  const std::size_t column = block.column_of(GGroup::motion);
  if (state.modal.plane != 170)
    return context.faults.fail("spline-plane", "a spline outside the XY plane", "use G17", column);
  if (state.compensation.radius > 0.0) {
    return context.faults.fail("spline-with-compensation", "a spline while cutter radius compensation is on",
                               "end it with G40 first", column);
  }
  if (block.has_any(word_bit('z') | kRotaryBits)) {
    return context.faults.fail("spline-axes", "a spline moves X and Y alone",
                               "move the other axes in a block of their own", column);
  }
  return true;
}

bool spline_feedrate(Context& context, const Block& block, const SplineDetail& spline, Feedrate& feed) {
  for (const auto& point : spline.points) {
    if (point.cwiseAbs().maxCoeff() <= kFarthest) continue;
    return context.faults.fail("coordinate-too-large", fmt::format("a control point more than {:g} mm away", kFarthest),
                               "check the numbers", block.column_of(GGroup::motion));
  }
  const double length = context.state.modal.feed_mode == 930 ? length_of_spline(spline) : 0.0;
  const double x = context.state.position[0];
  return find_feedrate(context, block, {length, 0.0, x, x}, feed);
}

bool write_bezier(Context& context, const Block& block, const std::vector<std::array<double, 2>>& inner,
                  const Position& end) {
  State& state = context.state;
  SplineDetail spline;
  spline.degree = static_cast<int>(inner.size()) + 1;
  spline.points.push_back(machine_vector(state.offsets, state.position).head<3>());
  for (const auto& p : inner) spline.points.push_back(machine_point(state.offsets, state.position, p[0], p[1]));
  spline.points.push_back(machine_vector(state.offsets, end).head<3>());
  spline.weights.assign(spline.points.size(), 1.0);
  spline.knots = clamped_knots(spline.points.size(), spline.degree + 1);
  Feedrate feed;
  if (!spline_feedrate(context, block, spline, feed)) return false;
  context.out.spline(state.offsets, end, std::move(spline), feed.linear);
  state.position = end;
  state.modal.motion = 800;  // each of these curves is named in its block
  return true;
}

}  // namespace

bool run_cubic_spline(Context& context, const Block& block) {
  State& state = context.state;
  const std::size_t column = block.column_of(GGroup::motion);
  if (!check_spline(context, block)) return false;
  if (!block.has('p') || !block.has('q')) {
    return context.faults.fail("spline-words", "G5 without P and Q", "give the second handle with P and Q", column);
  }
  if (block.has('i') != block.has('j')) {
    return context.faults.fail("spline-words", "G5 with only one of I and J",
                               "give both, or none to mirror the last handle", column);
  }
  Position end;
  if (!find_end(context, block, end)) return false;
  const Position& start = state.position;
  std::array<double, 2> handle = state.spline.after_cubic ? state.spline.last_handle : std::array<double, 2>{};
  if (block.has('i')) handle = {length_of(state, block, 'i'), length_of(state, block, 'j')};
  const std::array<double, 2> back = {length_of(state, block, 'p'), length_of(state, block, 'q')};
  const std::array<double, 2> first = {start[0] + handle[0], start[1] + handle[1]};
  const std::array<double, 2> second = {end[0] + back[0], end[1] + back[1]};
  if (!write_bezier(context, block, {first, second}, end)) return false;
  state.spline.last_handle = {-back[0], -back[1]};
  state.spline.after_cubic = true;
  return true;
}

bool run_quadratic_spline(Context& context, const Block& block) {
  State& state = context.state;
  if (!check_spline(context, block)) return false;
  if (!block.has('i') || !block.has('j')) {
    return context.faults.fail("spline-words", "G5.1 without I and J", "give the handle with I and J",
                               block.column_of(GGroup::motion));
  }
  Position end;
  if (!find_end(context, block, end)) return false;
  const double unit = state.modal.unit();
  const std::array<double, 2> middle = {state.position[0] + block.of('i', 0.0) * unit,
                                        state.position[1] + block.of('j', 0.0) * unit};
  return write_bezier(context, block, {middle}, end);
}

bool collect_nurbs(Context& context, const Block& block) {
  State& state = context.state;
  SplineMemory& spline = state.spline;
  if (!check_spline(context, block)) return false;
  const double weight = block.of('p', 0.0);
  if (!(weight > 0.0)) {
    return context.faults.fail("spline-weight", "a control point without a positive weight", "give its weight with P",
                               block.column_of('p'));
  }
  const bool opens = !spline.collecting;
  if (opens) {
    const double order = block.of('l', 3.0);
    if (!(order >= 2.0 && order <= kHighestOrder)) {
      return context.faults.fail("spline-order", fmt::format("order L{:g} of a spline", order),
                                 "orders go from 2 to 20", block.column_of('l'));
    }
    spline.collecting = true;
    spline.inverse_feed.reset();
    spline.order = static_cast<int>(order);
    spline.points.clear();
    const bool has_point = block.has('x') || block.has('y');
    spline.points.push_back({state.position[0], state.position[1], has_point ? 1.0 : weight});
    if (!has_point) {
      if (block.has('f')) spline.inverse_feed = block.of('f');
      return true;
    }
  }
  if (block.has('f')) spline.inverse_feed = block.of('f');
  Position end;
  if (!find_end(context, block, end)) return false;
  if (spline.points.size() >= kMostControlPoints) {
    return context.faults.fail("spline-too-long",
                               fmt::format("a spline of more than {} control points", kMostControlPoints),
                               "split the spline");
  }
  spline.points.push_back({end[0], end[1], weight});
  return true;
}

bool finish_nurbs(Context& context, const Block& block) {
  State& state = context.state;
  SplineMemory& memory = state.spline;
  const std::size_t column = block.column_of(GGroup::motion);
  if (!memory.collecting)
    return context.faults.fail("spline-not-open", "G5.3 without G5.2", "open the spline with G5.2", column);
  memory.collecting = false;
  state.modal.motion = 800;
  if (memory.points.size() < static_cast<std::size_t>(memory.order)) {
    return context.faults.fail(
        "spline-too-short",
        fmt::format("a spline of order {} with {} control points", memory.order, memory.points.size()),
        "give at least as many control points as the order", column);
  }
  SplineDetail spline;
  spline.degree = memory.order - 1;
  for (const auto& p : memory.points) {
    spline.points.push_back(machine_point(state.offsets, state.position, p[0], p[1]));
    spline.weights.push_back(p[2]);
  }
  spline.knots = clamped_knots(spline.points.size(), memory.order);
  Position end = state.position;
  end[0] = memory.points.back()[0];
  end[1] = memory.points.back()[1];
  Feedrate feed;
  Block with_feed = block;
  if (!block.has('f') && memory.inverse_feed) {
    with_feed.words |= word_bit('f');
    with_feed.value[word_index('f')] = *memory.inverse_feed;
  }
  if (!spline_feedrate(context, with_feed, spline, feed)) return false;
  context.out.spline(state.offsets, end, std::move(spline), feed.linear);
  state.position = end;
  return true;
}

}  // namespace toolpace::nc
