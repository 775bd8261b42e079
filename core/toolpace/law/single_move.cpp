#include "toolpace/law/single_move.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "toolpace/base/numbers.h"

namespace toolpace {
namespace {

constexpr double kSmallest = 1e-30;
constexpr double kLargest = 1e30;

bool is_sound(double value) { return value == 0 || (value >= kSmallest && value <= kLargest); }
bool is_limit(double value) { return value >= kSmallest && (value <= kLargest || std::isinf(value)); }

bool is_sound(const RampLimits& l) { return is_limit(l.acceleration) && is_limit(l.jerk) && is_sound(l.time); }

bool is_sound(const MoveRequest& move, const Dynamics& dynamics) {
  return is_sound(move.length) && is_sound(move.feed) && is_sound(move.start) && is_sound(move.end) && move.feed > 0 &&
         is_sound(dynamics.up) && is_sound(dynamics.down);
}

Error unusable(std::string what, double value, std::string remedy) {
  return {
      ErrorKind::usage, "number-out-of-range", std::move(what) + " is " + to_text(value), std::move(remedy), {}, {}};
}

/// Names the number that is_sound() refused.
Error describe_unsound(const MoveRequest& move, const Dynamics& dynamics) {
  struct Entry {
    const char* name;
    double value;
    bool is_fine;
    const char* remedy;
  };
  const char* kZero = "it must be 0 or between 1e-30 and 1e30";
  const char* kPositive = "it must be between 1e-30 and 1e30";
  const char* kLimit = "it must be between 1e-30 and 1e30, or inf for no limit";
  const auto limit = [&](const char* name, double value) { return Entry{name, value, is_limit(value), kLimit}; };
  const std::array entries{Entry{"the length", move.length, is_sound(move.length), kZero},
                           Entry{"the feed", move.feed, is_sound(move.feed) && move.feed > 0, kPositive},
                           Entry{"the start speed", move.start, is_sound(move.start), kZero},
                           Entry{"the end speed", move.end, is_sound(move.end), kZero},
                           limit("the acceleration limit", dynamics.up.acceleration),
                           limit("the deceleration limit", dynamics.down.acceleration),
                           limit("the jerk limit", dynamics.up.jerk),
                           limit("the jerk limit while slowing down", dynamics.down.jerk),
                           Entry{"the acceleration time", dynamics.up.time, is_sound(dynamics.up.time), kZero},
                           Entry{"the deceleration time", dynamics.down.time, is_sound(dynamics.down.time), kZero}};
  for (const Entry& e : entries) {
    if (!e.is_fine) return unusable(e.name, e.value, e.remedy);
  }
  return unusable("a number", 0.0, "");
}

/// The one ramp that a move cannot do without, from its faster end to its slower end or back.
struct NeededRamp {
  const LawRow& law;
  const MoveRequest& move;
  const RampLimits& limits;

  double length(double end) const { return (move.start + end) / 2 * law.duration(std::abs(end - move.start), limits); }
  bool fits(double end) const { return length(end) <= move.length; }

  /// Where fits() changes between a speed where it is true and one where it is not; the side where it is true.
  double boundary(double good, double bad) const {
    for (int i = 0; i < 200 && std::abs(good - bad) > 1e-15 * move.start; ++i) {
      const double middle = good + (bad - good) / 2;
      (fits(middle) ? good : bad) = middle;
    }
    return good;
  }

  /// reach(), less the few ulp that it may be too high.
  double fastest_end() const {
    double end = law.reach(move.start, move.length, limits);
    for (double ulps = 1e-16; ulps < 1 && !fits(end); ulps *= 2) end = std::max(end - ulps * end, move.start);
    return end;
  }

  /// The end speed nearest to the one asked for that can be reached.
  ///
  /// When slowing down, the length is not monotone in the end speed: under a jerk limit a ramp to v1 < v0/3 is shorter
  /// the slower v1 is. So both sides are searched, on a grid and then by bisection.
  double nearest_end() const {
    if (move.end > move.start) return fastest_end();
    constexpr int kGrid = 512;
    double best = move.start;
    for (const double far : {0.0, move.start}) {
      double before = move.end;
      for (int i = 1; i <= kGrid; ++i) {
        const double end = i == kGrid ? far : move.end + (far - move.end) * i / kGrid;
        if (fits(end)) {
          const double found = boundary(end, before);
          if (std::abs(found - move.end) < std::abs(best - move.end)) best = found;
          break;
        }
        before = end;
      }
    }
    return best;
  }
};

Error unreachable(const NeededRamp& ramp) {
  const MoveRequest& move = ramp.move;
  const double nearest = ramp.nearest_end();
  const double length = ramp.length(move.end);
  return {ErrorKind::infeasible,
          "exit-unreachable",
          "a " + std::string(ramp.law.id) + " ramp from speed " + to_text(move.start) + " to " + to_text(move.end) +
              " needs a length of " + to_text(length) + ", the move is " + to_text(move.length) + " long",
          "take an end speed of " + to_text(nearest) + ", or a length of at least " + to_text(length),
          {},
          nearest};
}

Error above_feed(const MoveRequest& move) {
  const bool at_start = move.start > move.feed;
  return {ErrorKind::usage,
          "speed-above-feed",
          std::string(at_start ? "the start speed " : "the end speed ") + to_text(at_start ? move.start : move.end) +
              " is above the feed " + to_text(move.feed),
          "raise the feed or lower the speed to it",
          {},
          move.feed};
}

}  // namespace

std::optional<Error> check_move(LawKind law, const MoveRequest& move, const Dynamics& dynamics) {
  if (!is_sound(move, dynamics)) return describe_unsound(move, dynamics);
  if (move.start > move.feed || move.end > move.feed) return above_feed(move);
  if (move.start == move.end) return std::nullopt;
  const NeededRamp ramp{law_row(law), move, move.end > move.start ? dynamics.up : dynamics.down};
  constexpr double kSlack = 1 + 1e-14;  // a length that was computed as the ramp's own is enough
  if (ramp.length(move.end) <= move.length * kSlack) return std::nullopt;
  return unreachable(ramp);
}

detail::FittedPeak detail::fitting_peak(const MoveRequest& move, const MoveTerms& terms) {
  const double least = std::max(move.start, move.end);
  FittedPeak peak{peak_speed(move, terms), 0.0, 0.0};
  for (double ulps = 1.2e-16;; ulps *= 2) {
    peak.up_time = terms.up.duration(peak.speed - move.start);
    peak.down_time = terms.down.duration(peak.speed - move.end);
    const double length = (move.start + peak.speed) / 2 * peak.up_time + (peak.speed + move.end) / 2 * peak.down_time;
    if (length <= move.length * (1 + 1e-14) || peak.speed <= least) return peak;
    peak.speed = std::max(peak.speed - ulps * peak.speed, least);
  }
}

Result<SingleMove> single_move(LawKind law, const MoveRequest& move, const Dynamics& dynamics) {
  return visit_law(law, [&](auto kind) { return single_move<decltype(kind)>(move, dynamics); });
}

}  // namespace toolpace
