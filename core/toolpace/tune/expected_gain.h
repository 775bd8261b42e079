#pragma once
/// What a guess promises.

#include <vector>

#include "toolpace/tune/surrogate.h"

namespace toolpace {

/// Logarithms of a cycle time and a contour error.
struct LogPoint {
  double time, error;
};

/// A front of two objectives and the point that bounds what counts.
struct LogFront {
  std::vector<LogPoint> points;  ///< by rising time, falling error
  LogPoint reference = {};

  /// Takes a point in, if it is not dominated, and drops those that it dominates.
  void add(const LogPoint& point);

  /// Hypervolume that a point of these guesses adds, as it may be expected. Both are independent and normal.
  /// The area above a point falls into strips between the times of the front's points, each with the error of the point before it as
  /// its ceiling; in a strip the expected width and the expected height are independent.
  /// @source Emmerich, Deutz, Klinkenberg 2011, two objectives
  double expected_gain(const Guess& time, const Guess& error) const;
};

/// Time (its logarithm) that is saved against `fastest` within `limit` on the error, as it may be expected: with nothing within it so
/// far (infinite `fastest`), the probability that this is.
double expected_saving(const Guess& time, const Guess& error, double fastest, double limit);

/// What is known and guessed of all candidates, as a batch of them is chosen one by one.
struct Expectation {
  Surrogate time, error;  ///< of the logarithms
  LogFront known;
  double limit, fastest;  ///< logarithms: on the error; the least time within it so far

  double gain(std::size_t candidate, bool for_limit) const;
  /// As if a candidate had been tried and were as guessed.
  void believe(std::size_t candidate);
};

}  // namespace toolpace
