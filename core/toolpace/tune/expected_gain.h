#pragma once
/// What a guess promises.

#include <vector>

#include "toolpace/tune/surrogate.h"

namespace toolpace {

/// Logarithms of a cycle time and of a flaw: contour error or vibration.
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

/// Time (its logarithm) that is saved against `fastest`, as it may be expected, where it is within limits with some probability: with
/// nothing within them so far (infinite `fastest`), that probability.
double expected_saving(const Guess& time, double within, double fastest);

/// That a guess is no higher.
double probability_below(double ceiling, const Guess& guess);

/// What is known and guessed of all candidates, as a batch of them is chosen one by one.
struct Expectation {
  /// What is guessed of a flaw, and how large it may be.
  struct Limited {
    Surrogate guess;
    double limit;
  };
  Surrogate time;  ///< of the logarithms, as all else here
  std::vector<Limited> flaws;
  std::size_t weighed;  ///< the flaw that `known` is the front of
  LogFront known;
  double fastest;  ///< the least time within all limits so far

  double gain(std::size_t candidate, bool for_limit) const;
  /// As if a candidate had been tried and were as guessed.
  void believe(std::size_t candidate);
};

}  // namespace toolpace
