#include "toolpace/tune/search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/tune/expected_gain.h"

namespace toolpace {
namespace {

constexpr double kFloor = 1e-6;       // [mm] below which contour errors are all the same
constexpr double kWidest = 4;         // times the least cycle time: slower settings are of no use
constexpr double kMargin = 0.1;       // of the reference point, in logarithms
constexpr double kDearWeight = 0.25;  // of what takes long to plan
constexpr double kAtHome = 0.3;       // of a spread position's knobs of numbers
constexpr std::size_t kMostKnown = 256, kSpreadPool = 160, kLocalPool = 320;
constexpr std::size_t kRefitEvery = 3;                        // batches
constexpr std::size_t kLimitEvery = 4, kGivenLimitEvery = 2;  // proposals, and positions near the best
constexpr std::array<std::size_t, kKnobCount> kBases = {2, 3, 5, 7, 11, 13, 17, 19};

/// The index in base b, mirrored at the point. @source Halton 1960
double radical_inverse(std::size_t index, std::size_t base) {
  double value = 0, digit = 1.0 / static_cast<double>(base);
  for (; index > 0; index /= base, digit /= static_cast<double>(base))
    value += digit * static_cast<double>(index % base);
  return value;
}

double log_time(const Tried& t) { return std::log(std::max(t.objectives.cycle_time, kFloor)); }
double log_flaw(double size) { return std::log(size + kFloor); }

std::vector<std::size_t> front_of(const std::vector<Tried>& tried, Flaw flaw) {
  std::vector<Objectives> objectives;
  for (const Tried& t : tried) objectives.push_back(t.objectives);
  return pareto_front(objectives, flaw);
}

/// What is best known where it matters: front after front is peeled off.
std::vector<Tried> most_telling(std::vector<Tried> tried, Flaw flaw) {
  if (tried.size() <= kMostKnown) return tried;
  std::vector<Tried> telling;
  while (telling.size() < kMostKnown && !tried.empty()) {
    auto front = front_of(tried, flaw);
    for (const std::size_t i : front) telling.push_back(tried[i]);
    std::sort(front.rbegin(), front.rend());
    for (const std::size_t i : front) tried.erase(tried.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return telling;
}

/// The logarithm of the least time.
double fastest_within(const std::vector<Tried>& tried, const FlawLimits& limits) {
  double best = std::numeric_limits<double>::infinity();
  for (const Tried& t : tried) {
    if (limits.keeps(t.objectives)) best = std::min(best, log_time(t));
  }
  return best;
}

}  // namespace

std::size_t Search::random_below(std::size_t count) {
  // splitmix64, as distributions of the standard library differ from one to the next
  std::uint64_t z = random_ += 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return static_cast<std::size_t>((z ^ (z >> 31)) % count);
}

/// One of eight may take long, where the job itself does not.
bool Search::may_be_dear() const {
  constexpr std::size_t kFirst = 2, kOneOf = 8;
  return space_.is_dear(space_.home()) || dear_ < kFirst + seen_.size() / kOneOf;
}

void Search::propose(const Position& position, std::vector<Position>& list) {
  const Position canonical = space_.canonical(position);
  const bool is_dear = space_.is_dear(canonical);
  if (is_dear && !may_be_dear()) return;
  if (!seen_.insert(canonical).second) return;
  dear_ += is_dear ? 1 : 0;
  list.push_back(canonical);
}

Position Search::spread(std::size_t index) const {
  Position p = space_.home();
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    const auto knob = static_cast<Knob>(k);
    double share = radical_inverse(index, kBases[k]);
    if (!TuningSpace::is_choice(knob)) {
      if (share < kAtHome) continue;
      share = (share - kAtHome) / (1 - kAtHome);
    }
    p[k] = static_cast<std::uint16_t>(share * static_cast<double>(space_.places(knob)));
  }
  return space_.canonical(p);
}

std::vector<Position> Search::first(std::size_t count) {
  std::vector<Position> list;
  propose(space_.home(), list);
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    const auto knob = static_cast<Knob>(k);
    if (!TuningSpace::is_choice(knob)) continue;
    for (std::size_t place = 0; place < space_.places(knob) && list.size() < count; ++place) {
      Position p = space_.home();
      p[k] = static_cast<std::uint16_t>(place);
      propose(p, list);
    }
  }
  for (std::size_t tries = 0; list.size() < count && tries < 8 * count; ++tries) propose(spread(++spread_), list);
  std::stable_partition(list.begin() + 1, list.end(), [&](const Position& p) { return !space_.is_dear(p); });
  return list;
}

/// One or two knobs turned, numbers by a few places more often than by many.
Position Search::turned(const Position& from) {
  Position p = from;
  const std::size_t turns = 1 + random_below(2);
  for (std::size_t i = 0; i < turns; ++i) {
    const std::size_t k = random_below(kKnobCount);
    const auto knob = static_cast<Knob>(k);
    const std::size_t places = space_.places(knob);
    if (places < 2) continue;
    if (TuningSpace::is_choice(knob)) {
      p[k] = static_cast<std::uint16_t>(random_below(places));
      continue;
    }
    const std::size_t far = 1 + random_below(std::size_t{1} << random_below(6));
    const bool up = random_below(2) == 0;
    p[k] = static_cast<std::uint16_t>(up ? std::min(places - 1, p[k] + far) : p[k] - std::min<std::size_t>(p[k], far));
  }
  return space_.canonical(p);
}

Search::Pool Search::pool_around(const std::vector<Tried>& tried, const std::vector<std::size_t>& front,
                                 const FlawLimits& limits) {
  std::set<Position> places;
  const auto add = [&](const Position& p) {
    if (!seen_.contains(p)) places.insert(p);
  };
  for (std::size_t i = 0; i < kSpreadPool; ++i) add(spread(++spread_));
  // The front's time rises: the first one within the limits is the best there, as far as one flaw tells.
  std::size_t best = 0;
  while (best + 1 < front.size() && !limits.keeps(tried[front[best]].objectives)) ++best;
  for (std::size_t i = 0; i < kLocalPool; ++i) {
    const std::size_t nth = i % kLimitEvery == 0 ? best : random_below(front.size());
    add(turned(tried[front[nth]].at));
  }
  Pool pool;
  pool.at.assign(places.begin(), places.end());
  pool.is_taken.assign(pool.at.size(), false);
  for (const Position& p : pool.at) pool.is_dear.push_back(space_.is_dear(p));
  return pool;
}

std::vector<Position> Search::next(const std::vector<Tried>& all, std::size_t count) {
  std::vector<Position> list;
  if (all.empty()) return list;
  const Objectives& present = all.front().objectives;
  const bool both = present.vibration.has_value();
  const Flaw weighed = both && batches_ % 2 == 1 ? Flaw::vibration : Flaw::contour;
  const FlawLimits limits = {contour_.value_or(present.contour),
                             both ? vibration_.value_or(*present.vibration) : kUnlimited};
  const std::vector<Tried> tried = most_telling(all, weighed);
  const std::vector<std::size_t> front = front_of(tried, weighed);
  Pool pool = pool_around(tried, front, limits);
  Expectation expected = expect(tried, front, pool, weighed, limits);
  const std::size_t limit_every = contour_ || vibration_ ? kGivenLimitEvery : kLimitEvery;
  for (std::size_t n = 0; n < count; ++n) {
    const bool for_limit = n % limit_every == limit_every - 1;
    double most = -1;
    std::size_t best = pool.at.size();
    for (std::size_t c = 0; c < pool.at.size(); ++c) {
      if (pool.is_taken[c] || (pool.is_dear[c] && !may_be_dear())) continue;
      const double gain = (pool.is_dear[c] ? kDearWeight : 1.0) * expected.gain(c, for_limit);
      if (gain <= most) continue;
      most = gain;
      best = c;
    }
    if (best == pool.at.size()) break;
    pool.is_taken[best] = true;
    propose(pool.at[best], list);
    expected.believe(best);
  }
  return list;
}

Expectation Search::expect(const std::vector<Tried>& tried, const std::vector<std::size_t>& front, const Pool& pool,
                           Flaw weighed, const FlawLimits& limits) {
  std::vector<Features> at, candidates;
  for (const Tried& t : tried) at.push_back(features_of(space_, t.at));
  for (const Position& p : pool.at) candidates.push_back(features_of(space_, p));
  const bool refits = batches_++ % kRefitEvery == 0;
  const auto surrogate = [&](const std::vector<double>& values, Surrogate::Lengths& lengths) {
    if (refits) lengths = Surrogate::fit(at, values, lengths);
    return Surrogate(at, values, lengths, candidates);
  };
  std::vector<double> times;
  for (const Tried& t : tried) times.push_back(log_time(t));
  Expectation e{
      surrogate(times, time_lengths_), {}, static_cast<std::size_t>(weighed), {}, fastest_within(tried, limits)};
  for (const Flaw flaw : {Flaw::contour, Flaw::vibration}) {
    if (flaw == Flaw::vibration && !tried.front().objectives.vibration) continue;
    std::vector<double> sizes;
    for (const Tried& t : tried) sizes.push_back(log_flaw(size_of(flaw, t.objectives)));
    e.flaws.push_back({surrogate(sizes, flaw_lengths_[static_cast<std::size_t>(flaw)]), log_flaw(limits.of(flaw))});
  }
  for (const std::size_t i : front) e.known.add({times[i], log_flaw(size_of(weighed, tried[i].objectives))});
  e.known.reference = {e.known.points.front().time + std::log(kWidest), e.known.points.front().error + kMargin};
  return e;
}

}  // namespace toolpace
