#include "toolpace/trace/align.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/base/axis_unit.h"
#include "toolpace/trace/coarse_offset.h"

namespace toolpace {
namespace {

using Columns = std::array<std::vector<double>, kAxisCount>;

constexpr std::size_t kParts = 16;  // whose offsets tell the drift
constexpr std::size_t kRowsLookedAt =
    1 << 17;  // of longer traces every second, third, … row: clocks are known well enough
constexpr int kMostRounds = 8;
constexpr double kSettled = 1e-4;     // of a step, that an offset still moves by
constexpr double kClearDrift = 4;     // in standard errors
constexpr double kStill = 1e-6;       // [mm, rad]
constexpr double kWrongScale = 0.15;  // of the way, that an axis may go too far or too short

Error align_error(const char* code, std::string message, std::string remedy, const Trace& trace) {
  return {ErrorKind::input, code, std::move(message), std::move(remedy), {trace.name, trace.first_line, 1}, {}};
}

bool moves(const std::vector<double>& position) {
  const auto [least, most] = std::minmax_element(position.begin(), position.end());
  return *most - *least > kStill;
}

/// What is summed over a stretch of rows for y − r = −late·ṙ.
struct Part {
  double weight = 0, product = 0, time = 0, squares = 0;
};

/// Least squares of one axis: y = scale·r + shift − late·ṙ, over rows inside of the program.
struct AxisSums {
  double n = 0, r = 0, y = 0, rr = 0, ry = 0, v = 0, vv = 0, ev = 0, e = 0, ee = 0;
};

class Aligner {
 public:
  Aligner(const CommandedRows& commanded, const Trace& trace, const Columns& measured, Alignment& alignment)
      : commanded_(commanded), trace_(trace), measured_(measured), a_(alignment) {}

  void refine() {
    for (int round = 0; round < kMostRounds; ++round) {
      shift_axes();
      if (!(std::abs(move_clock()) > kSettled * trace_.step)) break;
    }
    shift_axes();
  }

  /// The zeros alone, the clock as it is.
  void refine_shifts() { shift_axes(); }

  double scale(std::size_t axis) const { return scale_[axis]; }
  /// RMS of the following error by that of the commanded positions about their mean.
  double unlike(std::size_t axis) const { return unlike_[axis]; }

 private:
  /// The zero of each axis, its lag apart.
  void shift_axes() {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!a_.axis[axis]) continue;
      AxisSums s;
      const auto& y = measured_[axis];
      const double zero = commanded_.position[axis].front();  // far from the origin squares would lose digits
      for_each_inside(axis, [&](std::size_t i, const CommandedPoint& p) {
        const double r = p.position - zero, e = y[i] - p.position;
        s.n += 1, s.r += r, s.y += y[i] - zero, s.rr += r * r, s.ry += r * (y[i] - zero);
        s.v += p.speed, s.vv += p.speed * p.speed, s.ev += e * p.speed, s.e += e, s.ee += e * e;
      });
      if (s.n < 2) continue;
      const double of_r = s.rr - s.r * s.r / s.n, of_v = s.vv - s.v * s.v / s.n;
      scale_[axis] = of_r > 0 ? (s.ry - s.r * s.y / s.n) / of_r : 1.0;
      const double slope = of_v > 0 ? (s.ev - s.v * s.e / s.n) / of_v : 0.0;
      a_.shift[axis] = (s.e - slope * s.v) / s.n;
      unlike_[axis] = of_r > 0 ? std::sqrt(std::max(0.0, s.ee - s.e * s.e / s.n) / of_r) : 0.0;
    }
  }

  /// The offset of each part, and a line through them. @return [s] by how much the clock was set
  double move_clock() {
    std::array<Part, kParts> parts;
    const auto& time = trace_.rows.time;
    const double begin = time.front(), length = time.back() - begin;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!a_.axis[axis]) continue;
      for_each_inside(axis, [&](std::size_t i, const CommandedPoint& p) {
        const double share = (time[i] - begin) / length;
        Part& part = parts[std::min(kParts - 1, static_cast<std::size_t>(share * kParts))];
        const double e = measured_[axis][i] - p.position - a_.shift[axis];
        part.weight += p.speed * p.speed;
        part.product += e * p.speed;
        part.time += p.speed * p.speed * (time[i] - begin);
        part.squares += e * e;
      });
    }
    return fit_line(parts, length);
  }

  /// offset(t) = ahead + gain·(t − middle), weighted by the energy of the parts.
  double fit_line(const std::array<Part, kParts>& parts, double length) {
    double w = 0, wt = 0, wo = 0, wtt = 0, wto = 0;
    std::size_t used = 0;
    double most = 0;
    for (const Part& p : parts) most = std::max(most, p.weight);
    for (const Part& p : parts) {
      if (p.weight <= 1e-3 * most) continue;
      const double t = p.time / p.weight, o = p.product / p.weight;
      w += p.weight, wt += p.weight * t, wo += p.weight * o, wtt += p.weight * t * t, wto += p.weight * t * o;
      ++used;
    }
    if (w == 0) return 0;
    const double middle = wt / w, spread = wtt - w * middle * middle;
    const double ahead = wo / w,
                 gain = used > 2 && spread > 1e-6 * w * length * length ? (wto - middle * wo) / spread : 0.0;
    double scatter = 0;
    for (const Part& p : parts) {
      if (p.weight <= 1e-3 * most) continue;
      const double off = p.product / p.weight - ahead - gain * (p.time / p.weight - middle);
      scatter += p.weight * off * off;
    }
    const double variance = used > 2 ? scatter / static_cast<double>(used - 2) : 0.0;
    a_.offset_error = std::sqrt(variance / w);
    a_.drift_error = gain != 0 ? std::sqrt(variance / spread) : 0.0;
    const double drift = a_.drift + gain;
    const bool shows = std::abs(drift) > kClearDrift * a_.drift_error && gain != 0;
    // The clock is turned about the middle of the motion.
    const double old = a_.offset + a_.drift * middle;
    a_.drift = shows ? drift : 0.0;
    a_.offset = old + ahead - a_.drift * middle;
    return ahead;
  }

  template <class F>
  void for_each_inside(std::size_t axis, const F& use) const {
    const auto& time = trace_.rows.time;
    const auto& r = commanded_.position[axis];
    const double end = commanded_.duration();
    const std::size_t stride = 1 + time.size() / kRowsLookedAt;
    for (std::size_t i = 0; i < time.size(); i += stride) {
      const double t = a_.at(time[i]);
      if (t >= 0 && t <= end) use(i, commanded_at(r, commanded_.period, t));
    }
  }

  const CommandedRows& commanded_;
  const Trace& trace_;
  const Columns& measured_;
  Alignment& a_;
  std::array<double, kAxisCount> scale_ = {1, 1, 1, 1, 1, 1}, unlike_ = {};
};

std::string scale_text(double scale) {
  struct Known {
    double factor;
    const char* text;
  };
  constexpr std::array kKnown = {Known{25.4, "it may be in mm and read as inches"},
                                 Known{1 / 25.4, "it may be in inches and read as mm"},
                                 Known{1000, "it may be in µm and read as mm"},
                                 Known{1e-3, "it may be in m and read as mm"},
                                 Known{-1, "it runs the other way round"},
                                 Known{2, "it may be a diameter"},
                                 Known{0.5, "it may be a radius"},
                                 Known{180 / std::numbers::pi, "it may be in degrees and read as rad"},
                                 Known{std::numbers::pi / 180, "it may be in rad and read as degrees"}};
  for (const Known& k : kKnown) {
    if (std::abs(scale / k.factor - 1) < 0.05) return k.text;
  }
  return "its unit, or its column, is not what it is taken for";
}

Error other_program(const std::string& why, const Trace& trace) {
  return align_error("trace-other-program", "the trace is not of this program: " + why,
                     "give the setpoints that were run, and check which column is which axis", trace);
}

Result<void> check_likeness(const Aligner& measured, const Alignment& a, const Trace& trace) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!a.axis[axis]) continue;
    const double scale = measured.scale(axis);
    if (std::abs(scale - 1) >= kWrongScale) {
      return tl::unexpected(align_error(
          "trace-unit",
          fmt::format("axis {} goes {:.4g} times as far as commanded: {}", kAxisNames[axis], scale, scale_text(scale)),
          "say its column and unit: --columns x=NAME[mm], with mm, um, m, in, deg or rad", trace));
    }
    if (measured.unlike(axis) <= kMostUnlike) continue;
    return tl::unexpected(other_program(
        fmt::format("axis {} is off its command by {:.0f} % of its way", kAxisNames[axis], 100 * measured.unlike(axis)),
        trace));
  }
  return {};
}

}  // namespace

Result<Alignment> align(const CommandedRows& commanded, const Trace& trace, const Monitor& monitor) {
  Alignment a;
  a.first_time = trace.rows.time.front();
  bool any = false, any_commanded = false;
  std::array<bool, kAxisCount> recorded = {};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (commanded.position[axis].empty() || trace.rows.actual[axis].empty() || !moves(commanded.position[axis]))
      continue;
    a.axis[axis] = any = true;
    any_commanded |= recorded[axis] = !trace.rows.commanded[axis].empty();
  }
  if (!any) {
    return tl::unexpected(align_error("trace-axes", "no axis that the program moves is in the trace",
                                      "say which columns are which axis: --columns x=NAME,y=NAME", trace));
  }
  a.by_commanded = any_commanded;
  const std::array<bool, kAxisCount> all = a.axis;
  if (any_commanded) a.axis = recorded;
  const Columns& clocked = any_commanded ? trace.rows.commanded : trace.rows.actual;
  const auto coarse = detail::coarse_offset(commanded, trace, clocked, a.axis);
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  a.correlation = coarse ? coarse->correlation : 0.0;
  if (!(a.correlation >= kLeastCorrelation)) {
    return tl::unexpected(other_program(
        fmt::format("its speeds correlate by {:.2f} at most, {} are needed", a.correlation, kLeastCorrelation), trace));
  }
  a.offset = coarse->offset;
  a.is_ambiguous = coarse->is_ambiguous;
  Aligner aligner(commanded, trace, clocked, a);
  aligner.refine();
  a.axis = all;
  Alignment still = a;  // the zeros, and the scales, of what was measured
  Aligner measured(commanded, trace, trace.rows.actual, still);
  measured.refine_shifts();
  a.shift = still.shift;
  if (auto fine = check_likeness(measured, a, trace); !fine) return tl::unexpected(fine.error());
  return a;
}

}  // namespace toolpace
