#include "toolpace/tune/expected_gain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toolpace {
namespace {

double probability_below(double ceiling, const Guess& guess) {
  return 0.5 * std::erfc((guess.mean - ceiling) / (guess.deviation * std::numbers::sqrt2));
}

/// Expectation of how far a guess lies below a ceiling, 0 where it does not.
double expected_below(double ceiling, const Guess& guess) {
  const double z = (ceiling - guess.mean) / guess.deviation;
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return (ceiling - guess.mean) * probability_below(ceiling, guess) + guess.deviation * density;
}

}  // namespace

void LogFront::add(const LogPoint& p) {
  const auto dominated = [&](const LogPoint& other) { return other.time <= p.time && other.error <= p.error; };
  if (std::any_of(points.begin(), points.end(), dominated)) return;
  std::erase_if(points, [&](const LogPoint& other) { return p.time <= other.time && p.error <= other.error; });
  points.insert(std::upper_bound(points.begin(), points.end(), p,
                                 [](const LogPoint& a, const LogPoint& b) { return a.time < b.time; }),
                p);
}

double LogFront::expected_gain(const Guess& time, const Guess& error) const {
  double gain = 0, ceiling = reference.error, below_before = 0;
  for (const LogPoint& p : points) {
    const double end = std::min(p.time, reference.time);
    const double below = expected_below(end, time);
    gain += (below - below_before) * expected_below(ceiling, error);
    below_before = below;
    ceiling = std::min(ceiling, p.error);
    if (p.time >= reference.time) return gain;
  }
  return gain + (expected_below(reference.time, time) - below_before) * expected_below(ceiling, error);
}

double expected_saving(const Guess& time, const Guess& error, double fastest, double limit) {
  const double within = probability_below(limit, error);
  return std::isfinite(fastest) ? within * expected_below(fastest, time) : within;
}

double Expectation::gain(std::size_t candidate, bool for_limit) const {
  const Guess t = time.at_candidate(candidate), e = error.at_candidate(candidate);
  return for_limit ? expected_saving(t, e, fastest, limit) : known.expected_gain(t, e);
}

void Expectation::believe(std::size_t candidate) {
  const LogPoint guessed = {time.at_candidate(candidate).mean, error.at_candidate(candidate).mean};
  known.add(guessed);
  if (guessed.error <= limit) fastest = std::min(fastest, guessed.time);
  time.believe(candidate);
  error.believe(candidate);
}

}  // namespace toolpace
