#pragma once
/// Where to look next.

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "toolpace/tune/expected_gain.h"
#include "toolpace/tune/pareto.h"
#include "toolpace/tune/surrogate.h"
#include "toolpace/tune/tuning_space.h"

namespace toolpace {

/// A position that was tried.
struct Tried {
  Position at;
  Objectives objectives;
};

/// First a design that covers the space: the job's own settings, each other choice alone, then places spread evenly over all knobs.
/// Then, batch by batch, positions from which Gaussian processes through the logarithms of cycle time, contour error and vibration expect
/// most: hypervolume gained by the front of time and one flaw (where vibration is known, the two in turns), or time saved within the
/// limits. What takes long to plan has to promise more.
/// Asked anew with the same tried positions it answers the same.
///
/// @source Emmerich, Deutz, Klinkenberg, "Hypervolume-based expected improvement: monotonicity properties and exact computation",
/// 2011, for two objectives; Gardner et al., "Bayesian optimization with inequality constraints", 2014, eq. (5); Ginsbourger, Le Riche,
/// Carraro, "Kriging is well-suited to parallelize optimization", 2010, for batches by believing.
class Search {
 public:
  /// @param contour, vibration  limits that the fastest is looked for under [mm; mm, deg]; nothing = the present settings' (the first
  ///                            one tried)
  Search(const TuningSpace& space, std::optional<double> contour, std::optional<double> vibration)
      : space_(space), contour_(contour), vibration_(vibration) {}

  /// At most `count`; those that take long to plan last.
  std::vector<Position> first(std::size_t count);
  /// At most `count`, none that was proposed before. Nothing where there is nothing left.
  std::vector<Position> next(const std::vector<Tried>& tried, std::size_t count);

 private:
  /// Positions that may be proposed.
  struct Pool {
    std::vector<Position> at;
    std::vector<bool> is_dear, is_taken;
  };
  bool may_be_dear() const;
  void propose(const Position& position, std::vector<Position>& list);
  Position spread(std::size_t index) const;
  Position turned(const Position& from);
  Pool pool_around(const std::vector<Tried>& tried, const std::vector<std::size_t>& front, const FlawLimits& limits);
  Expectation expect(const std::vector<Tried>& tried, const std::vector<std::size_t>& front, const Pool& pool,
                     Flaw weighed, const FlawLimits& limits);
  std::size_t random_below(std::size_t count);

  const TuningSpace& space_;
  std::optional<double> contour_, vibration_;
  std::set<Position> seen_;
  Surrogate::Lengths time_lengths_ = Surrogate::first_lengths();
  std::array<Surrogate::Lengths, 2> flaw_lengths_ = {Surrogate::first_lengths(), Surrogate::first_lengths()};
  std::size_t batches_ = 0, spread_ = 0, dear_ = 0;
  std::uint64_t random_ = 0x9E3779B97F4A7C15;
};

}  // namespace toolpace
