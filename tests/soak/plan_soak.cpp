/// Plans random chains for as long as one likes and checks every plan on its exact polynomials: plan_soak [BLOCKS [SEED]].
///
/// Memory stays that of one chain, at most a million blocks. Progress goes to stderr; each violation is a line on stdout
/// that names its chain. Exit 1 if there was any.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "plan_cases.h"
#include "plan_checker.h"
#include "toolpace/bound/path_bound.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

constexpr std::uint64_t kReportEvery = 20'000'000;

/// What is planned next: everything follows from the number.
struct Case {
  SpeedLimits limits;
  PlanOptions options;
  std::string name;
};

Case make_case(std::uint64_t seed) {
  // Mostly short chains, now and then one of a million blocks.
  constexpr std::size_t kSizes[] = {1, 3, 10, 30, 100, 300, 1000, 3000, 10000, 30000};
  const std::size_t size = seed % 997 == 0 ? 1000000 : kSizes[seed % std::size(kSizes)];
  const bool wild = seed % 7 == 0, mixed = seed % 3 == 0;
  Case c{wild ? test::wild_chain(seed) : test::random_chain(seed, size, mixed), {}, {}};
  const auto laws = law_table();
  c.options.law = laws[seed / 10 % laws.size()].kind;
  c.options.ramps = seed / 60 % 4 == 0 ? Ramps::block : Ramps::span;
  // Short look-aheads take many rounds: for short chains only.
  if (seed / 240 % 3 == 0) c.options.lookahead = c.limits.size() <= 100 ? 1 + seed / 720 % 12 : 1000 + seed % 9000;
  c.name = "seed " + std::to_string(seed) + (wild ? " wild " : " ") + std::to_string(c.limits.size()) + " blocks " +
           std::string(law_row(c.options.law).id) + (c.options.ramps == Ramps::span ? " span N " : " block N ") +
           (c.options.lookahead ? std::to_string(*c.options.lookahead) : "all") + (mixed ? " mixed" : "");
  return c;
}

/// Empty where all is well.
std::string find_fault(const Case& c) {
  const auto plan = plan_motion(c.limits, c.options);
  if (!plan) return plan.error().message;
  const bool smooth = law_row(c.options.law).bounds_jerk;
  std::string fault = test::find_offence(c.limits, *plan, {smooth, smooth, 1e-6});
  if (plan->cycle_time() < path_bound(c.limits, c.options.law)) fault += " faster than its bound";
  if (c.options.ramps != Ramps::span || !c.options.lookahead) return fault;
  PlanOptions deeper = c.options;
  ++*deeper.lookahead;
  const auto other = plan_motion(c.limits, deeper);
  if (!other || other->cycle_time() > plan->cycle_time() * (1 + 1e-12)) fault += " slower with one block more";
  return fault;
}

int run(double blocks, std::uint64_t seed) {
  std::uint64_t done = 0, reported = 0, chains = 0, faults = 0;
  for (; static_cast<double>(done) < blocks; ++seed, ++chains) {
    const Case c = make_case(seed);
    done += c.limits.size();
    if (const std::string fault = find_fault(c); !fault.empty()) {
      ++faults;
      std::printf("%s: %s\n", c.name.c_str(), fault.c_str());
      std::fflush(stdout);
    }
    if (done - reported < kReportEvery) continue;
    reported = done;
    std::fprintf(stderr, "%.0f of %.0f million blocks, %llu chains, %llu violations\n",
                 static_cast<double>(done) * 1e-6, blocks * 1e-6, static_cast<unsigned long long>(chains + 1),
                 static_cast<unsigned long long>(faults));
  }
  std::printf("%llu blocks, %llu chains, %llu violations\n", static_cast<unsigned long long>(done),
              static_cast<unsigned long long>(chains), static_cast<unsigned long long>(faults));
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace toolpace

int main(int argc, char** argv) {
  const double blocks = argc > 1 ? std::atof(argv[1]) : 1e9;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (!(blocks > 0)) {
    std::fputs("usage: plan_soak [BLOCKS [SEED]]\n", stderr);
    return 2;
  }
  return toolpace::run(blocks, seed);
}
