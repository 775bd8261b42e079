#include "toolpace/tune/expected_gain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toolpace {

double probability_below(double ceiling, const Guess& guess) {
  return 0.5 * std::erfc((guess.mean - ceiling) / (guess.deviation * std::numbers::sqrt2));
}

namespace {

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

double expected_saving(const Guess& time, double within, double fastest) {
  return std::isfinite(fastest) ? within * expected_below(fastest, time) : within;
}

double Expectation::gain(std::size_t candidate, bool for_limit) const {
  const Guess t = time.at_candidate(candidate);
  if (!for_limit) return known.expected_gain(t, flaws[weighed].guess.at_candidate(candidate));
  double within = 1;
  for (const Limited& f : flaws) within *= probability_below(f.limit, f.guess.at_candidate(candidate));
  return expected_saving(t, within, fastest);
}

void Expectation::believe(std::size_t candidate) {
  const double guessed = time.at_candidate(candidate).mean;
  known.add({guessed, flaws[weighed].guess.at_candidate(candidate).mean});
  const bool keeps = std::all_of(flaws.begin(), flaws.end(),
                                 [&](const Limited& f) { return f.guess.at_candidate(candidate).mean <= f.limit; });
  if (keeps) fastest = std::min(fastest, guessed);
  time.believe(candidate);
  for (Limited& f : flaws) f.guess.believe(candidate);
}

}  // namespace toolpace
