#include "toolpace/trace/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "toolpace/base/metric.h"
#include "toolpace/servo/contour_error.h"

namespace toolpace {
namespace {

constexpr double kClearShift = 0.1;       // [mm, deg] a smaller constant error is an error, and no other zero
constexpr double kClearOfErrors = 5;      // times the error that varies
constexpr std::size_t kLongestStand = 8;  // rows that an axis may repeat a value while it is to move
constexpr double kMovesOn = 0.05;         // [mm, deg] and more, while it stands
constexpr double kOfTravel = 0.005;       // of the axis' way in this program, and more

/// Sums over the rows of one axis for error = shift − lag·speed.
struct ErrorSums {
  double n = 0, e = 0, v = 0, ee = 0, ev = 0, vv = 0;

  void add(double error, double speed) {
    n += 1, e += error, v += speed, ee += error * error, ev += error * speed, vv += speed * speed;
  }
  double lag() const {
    const double of_v = vv - v * v / n;
    return of_v > 0 ? -(ev - e * v / n) / of_v : 0.0;
  }
};

/// The zero of an axis where it is clearly another one.
double shift_of(const ErrorSums& s, double shift, std::size_t axis) {
  if (s.n < 2) return 0;
  const double of_v = s.vv - s.v * s.v / s.n, of_ev = s.ev - s.e * s.v / s.n;
  const double left = std::max(0.0, s.ee - s.e * s.e / s.n - (of_v > 0 ? of_ev * of_ev / of_v : 0.0)) / s.n;
  const bool is_clear =
      std::abs(counted(axis, shift)) > kClearShift && std::abs(shift) > kClearOfErrors * std::sqrt(left);
  return is_clear ? shift : 0.0;
}

struct LineSums {
  double begin = 0, max_contour = 0, max_following = 0, contour = 0, following = 0;
  std::size_t rows = 0;
};

class Comparer {
 public:
  Comparer(const CommandedRows& commanded, const Trace& trace, Comparison& result)
      : commanded_(commanded), trace_(trace), c_(result) {}

  Result<void> run(std::vector<ComparedRow>* rows, const Monitor& monitor) {
    measure_axes();
    const auto& time = trace_.rows.time;
    std::size_t passed = 0;
    std::vector<ContourMeter::Row> measured;
    std::size_t handed = 0;
    const auto hand_out = [&](bool all) {
      measured.clear();
      meter_.measure(all, measured);
      for (const auto& m : measured) take(inside_[handed++], m, rows);
    };
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double t = c_.alignment.at(time[i]);
      if (t < 0 || t > commanded_.duration()) continue;
      for (; passed < commanded_.size() && static_cast<double>(passed) * commanded_.period < t; ++passed)
        meter_.pass(setpoint(passed));
      inside_.push_back({i, t});
      meter_.take(point(t), actual(i));
      if (inside_.size() % kReportEvery != 0) continue;
      hand_out(false);
      if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      monitor.report(static_cast<double>(i) / static_cast<double>(time.size()));
    }
    hand_out(true);
    finish();
    return {};
  }

 private:
  struct Inside {
    std::size_t row;
    double time;
  };

  AxisVector setpoint(std::size_t row) const {
    AxisVector p = AxisVector::Zero();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (c_.axis[axis].is_measured) p[static_cast<Eigen::Index>(axis)] = counted(axis, commanded_.position[axis][row]);
    }
    return p;
  }
  AxisVector point(double time) const {
    AxisVector p = AxisVector::Zero();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!c_.axis[axis].is_measured) continue;
      p[static_cast<Eigen::Index>(axis)] =
          counted(axis, commanded_at(commanded_.position[axis], commanded_.period, time).position);
    }
    return p;
  }
  AxisVector actual(std::size_t row) const {
    AxisVector p = AxisVector::Zero();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!c_.axis[axis].is_measured) continue;
      p[static_cast<Eigen::Index>(axis)] = counted(axis, trace_.rows.actual[axis][row] - c_.axis[axis].shift);
    }
    return p;
  }

  std::uint32_t line_at(double time) const {
    if (commanded_.line.empty()) return 0;
    const auto row = static_cast<std::size_t>(std::ceil(time / commanded_.period - 1e-6));
    return commanded_.line[std::min(row, commanded_.line.size() - 1)];
  }

  void measure_axes() {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!c_.axis[axis].is_measured) continue;
      ErrorSums sums;
      for_each_error(axis, [&](double, double error, double speed) { sums.add(error, speed); });
      AxisComparison& a = c_.axis[axis];
      a.shift = shift_of(sums, c_.alignment.shift[axis], axis);
      a.lag = sums.n > 1 ? sums.lag() : 0.0;
      double squares = 0;
      for_each_error(axis, [&](double time, double error, double) {
        const double off = error - a.shift;
        squares += off * off;
        if (std::abs(off) <= a.max_error) return;
        a.max_error = std::abs(off);
        a.worst_time = time;
      });
      a.rms_error = std::sqrt(squares / std::max(1.0, sums.n));
      a.worst_line = line_at(a.worst_time);
    }
  }

  template <class F>
  void for_each_error(std::size_t axis, const F& use) const {
    const auto& time = trace_.rows.time;
    const auto &r = commanded_.position[axis], &y = trace_.rows.actual[axis];
    const double end = commanded_.duration();
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double t = c_.alignment.at(time[i]);
      if (t < 0 || t > end) continue;
      const CommandedPoint p = commanded_at(r, commanded_.period, t);
      use(t, y[i] - p.position, p.speed);
    }
  }

  void take(const Inside& row, const ContourMeter::Row& m, std::vector<ComparedRow>* rows) {
    if (rows) rows->push_back({row.row, row.time, m.lag, m.contour});
    sum_contour_ += m.contour * m.contour;
    sum_following_ += m.lag * m.lag;
    c_.max_following = std::max(c_.max_following, m.lag);
    if (m.contour > c_.max_contour) c_.max_contour = m.contour, c_.worst_time = row.time;
    if (commanded_.line.empty()) return;
    const std::uint32_t line = line_at(row.time);
    if (!last_ || line != last_line_) last_ = &lines_[line], last_line_ = line;
    LineSums& l = *last_;
    if (l.rows++ == 0) l.begin = row.time;
    l.max_contour = std::max(l.max_contour, m.contour);
    l.max_following = std::max(l.max_following, m.lag);
    l.contour += m.contour * m.contour;
    l.following += m.lag * m.lag;
  }

  void finish() {
    c_.rows = inside_.size();
    c_.outside = trace_.size() - inside_.size();
    const double n = std::max<double>(1, static_cast<double>(c_.rows));
    c_.rms_contour = std::sqrt(sum_contour_ / n);
    c_.rms_following = std::sqrt(sum_following_ / n);
    c_.worst_line = line_at(c_.worst_time);
    for (const auto& [line, l] : lines_) {
      const auto rows = static_cast<double>(l.rows);
      c_.lines.push_back({line, l.begin, l.rows, l.max_contour, std::sqrt(l.contour / rows), l.max_following,
                          std::sqrt(l.following / rows)});
    }
    std::sort(c_.lines.begin(), c_.lines.end(),
              [](const LineComparison& a, const LineComparison& b) { return a.line < b.line; });
  }

  const CommandedRows& commanded_;
  const Trace& trace_;
  Comparison& c_;
  ContourMeter meter_;
  std::vector<Inside> inside_;
  std::unordered_map<std::uint32_t, LineSums> lines_;
  LineSums* last_ = nullptr;
  std::uint32_t last_line_ = 0;
  double sum_contour_ = 0, sum_following_ = 0;
};

/// The row at which an axis has stood too long at a value, or nothing.
std::optional<std::size_t> saturated_row(const CommandedRows& commanded, const Trace& trace, const Alignment& a,
                                         std::size_t axis) {
  const auto& y = trace.rows.actual[axis];
  const auto [least, most] = std::minmax_element(y.begin(), y.end());
  const auto& r = commanded.position[axis];
  const double moved = std::max(kMovesOn * (is_rotary(axis) ? kRadiansPerDegree : 1.0), kOfTravel * (*most - *least));
  const double end = commanded.duration();
  for (std::size_t i = 0; i < y.size();) {
    std::size_t next = i + 1;
    while (next < y.size() && y[next] == y[i]) ++next;
    const double begins = a.at(trace.rows.time[i]), ends = a.at(trace.rows.time[next - 1]);
    if (next - i > kLongestStand && (y[i] == *least || y[i] == *most) && ends > 0 && begins < end) {
      double low = commanded_at(r, commanded.period, begins).position, high = low;
      for (std::size_t k = i; k < next; ++k) {
        const double here = commanded_at(r, commanded.period, a.at(trace.rows.time[k])).position;
        low = std::min(low, here), high = std::max(high, here);
      }
      // A drive that lags comes to rest late and starts late, but goes where it is told.
      const double past = y[i] == *most ? high + a.shift[axis] - y[i] : y[i] - low - a.shift[axis];
      if (high - low > moved && past > moved) return i;
    }
    i = next;
  }
  return {};
}

}  // namespace

Result<void> check_saturation(const CommandedRows& commanded, const Trace& trace, const Alignment& alignment) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!alignment.axis[axis]) continue;
    const auto row = saturated_row(commanded, trace, alignment, axis);
    if (!row) continue;
    return tl::unexpected(
        Error{ErrorKind::input,
              "trace-saturated",
              fmt::format("axis {} stays at the end of what the channel can hold while it moves on", kAxisNames[axis]),
              "record again with a larger range of this channel",
              {trace.name, trace.first_line + *row, 1},
              {}});
  }
  return {};
}

Result<Comparison> compare(const CommandedRows& commanded, const Trace& trace, std::vector<ComparedRow>* rows,
                           const Monitor& monitor) {
  auto alignment = align(commanded, trace, monitor);
  if (!alignment) return tl::unexpected(alignment.error());
  if (auto fine = check_saturation(commanded, trace, *alignment); !fine) return tl::unexpected(fine.error());
  Comparison result;
  result.alignment = *alignment;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    result.axis[axis].is_measured = alignment->axis[axis];
    const auto& r = commanded.position[axis];
    const bool stands = r.empty() || std::all_of(r.begin(), r.end(), [&](double v) { return v == r.front(); });
    if (!alignment->axis[axis] && !stands) result.unmeasured.emplace_back(1, kAxisNames[axis]);
  }
  Comparer comparer(commanded, trace, result);
  if (auto done = comparer.run(rows, monitor); !done) return tl::unexpected(done.error());
  if (result.rows < kFewestTraceRows) {
    return tl::unexpected(Error{ErrorKind::input,
                                "trace-short",
                                fmt::format("only {} rows of the trace fall into the program", result.rows),
                                "record while the program runs",
                                {trace.name, trace.first_line, 1},
                                {}});
  }
  return result;
}

}  // namespace toolpace
