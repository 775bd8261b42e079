/// How well the tuner searches: its front against a full grid of as many plans, and its best under a limit on contour error against
/// that of a grid ten times its size. Prints one line a program.
///
///     tune_against_grid MACHINE.toml CONTOUR_UM PLANS PROGRAM…

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <set>

#include "toolpace/machine/read_machine.h"
#include "toolpace/nc/reader.h"
#include "toolpace/tune/tune.h"

namespace toolpace {
namespace {

/// Every combination of all choices with `levels` accelerations and jerks and two tolerances.
std::vector<Position> full_grid(const TuningSpace& space, std::size_t levels) {
  std::vector<Position> grid = {space.home()};
  const auto multiply = [&](Knob knob, std::size_t count) {
    std::vector<Position> more;
    const std::size_t places = space.places(knob);
    for (const Position& p : grid) {
      for (std::size_t i = 0; i < std::min(count, places); ++i) {
        Position q = p;
        const std::size_t place = TuningSpace::is_choice(knob) ? i : places - 1 - i * (places - 1) / count;
        q[static_cast<std::size_t>(knob)] = static_cast<std::uint16_t>(place);
        more.push_back(q);
      }
    }
    grid = std::move(more);
  };
  for (const Knob knob : {Knob::law, Knob::corner, Knob::ramps}) multiply(knob, space.places(knob));
  multiply(Knob::acceleration, levels);
  multiply(Knob::jerk, levels);
  multiply(Knob::tolerance, 2);
  std::set<Position> unique;
  for (const Position& p : grid) unique.insert(space.canonical(p));
  unique.erase(space.home());
  return {unique.begin(), unique.end()};
}

/// The largest grid of at most `plans`, or else one of three choices of each kind thinned out evenly.
std::vector<Position> grid_of(const TuningSpace& space, std::size_t plans) {
  std::size_t levels = 1;
  while (full_grid(space, levels + 1).size() < plans) ++levels;
  std::vector<Position> grid = full_grid(space, levels);
  if (grid.size() + 1 >= plans * 3 / 4) return grid;
  const std::vector<Position> finer = full_grid(space, levels + 1);
  grid.clear();
  for (std::size_t i = 0; i + 1 < plans; ++i) grid.push_back(finer[i * finer.size() / (plans - 1)]);
  return grid;
}

std::vector<Objectives> front_of(const TuneResult& t) {
  std::vector<Objectives> list;
  for (const Tuned& point : t.front) list.push_back(point.objectives);
  return list;
}

double best_of(const TuneResult& t) { return t.best ? t.front[*t.best].objectives.cycle_time : kUnlimited; }

int compare(const Setup& setup, double contour, std::size_t plans, const char* name) {
  auto reading = read_file(name, {});
  if (!reading || reading->refused) return std::fprintf(stderr, "%s: cannot be read\n", name), 1;
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  TuneOptions options;
  options.contour = contour;
  options.plans = plans;
  const TuningSpace space(job, options.turned);
  const auto grid = grid_of(space, plans), large = grid_of(space, 10 * plans);
  const auto found = tune(job, options);
  const auto by_grid = tune_by_list(space, grid, options), by_large = tune_by_list(space, large, options);
  if (!found || !by_grid || !by_large) return std::fprintf(stderr, "%s: cannot be planned\n", name), 1;
  // What counts: no slower than four times the fastest, no farther off than the fastest is.
  const auto &front = found->front.front().objectives, &other = by_large->front.front().objectives;
  const Objectives reference = {
      4 * std::min(front.cycle_time, other.cycle_time), std::max(front.contour, other.contour), {}};
  const double whole = reference.cycle_time * reference.contour;
  std::printf(
      "%s: hypervolume %.4f, grid of %zu %.4f, grid of %zu %.4f; best %.4f s, grid %.4f s, large grid %.4f s (%+.2f "
      "%%)\n",
      name, hypervolume(front_of(*found), reference) / whole, by_grid->plans,
      hypervolume(front_of(*by_grid), reference) / whole, by_large->plans,
      hypervolume(front_of(*by_large), reference) / whole, best_of(*found), best_of(*by_grid), best_of(*by_large),
      100 * (best_of(*found) / best_of(*by_large) - 1));
  std::fflush(stdout);
  return 0;
}

}  // namespace
}  // namespace toolpace

int main(int argc, char** argv) {
  if (argc < 5) return std::fprintf(stderr, "tune_against_grid MACHINE.toml CONTOUR_UM PLANS PROGRAM...\n"), 2;
  const auto setup = toolpace::read_machine(argv[1]);
  if (!setup) return std::fprintf(stderr, "%s\n", setup.error().message.c_str()), 2;
  int code = 0;
  for (int i = 4; i < argc; ++i)
    code |= toolpace::compare(*setup, std::atof(argv[2]) * 1e-3, std::strtoul(argv[3], nullptr, 10), argv[i]);
  return code;
}
