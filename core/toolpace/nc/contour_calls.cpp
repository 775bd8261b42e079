#include "toolpace/nc/contour_calls.h"

#include <fmt/format.h>

#include "toolpace/nc/motion/turning_cycles.h"

namespace toolpace::nc {
namespace {

constexpr std::size_t kMostSteps = 20'000'000;  // of one cycle's calculation
constexpr std::size_t kStepsOfALine = 8;        // counted as one line run again

}  // namespace

bool ContourCalls::turn(const Block& called, Code code) {
  const Block block = called;  // reading the contour overwrites the interpreter's own
  const Place place = flow_.place_of_fault();
  LatheCycle cycle;
  std::vector<ContourElement> contour;
  if (!begin_lathe_cycle(context_, block, code, cycle)) return false;
  const bool read = read_contour(block, cycle, contour);
  flow_.blame(place);
  if (!read) return false;
  WorkBudget budget(kMostSteps);
  const bool turned = run_lathe_cycle(context_, block, cycle, std::move(contour), budget);
  flow_.add_work((kMostSteps - budget.left()) / kStepsOfALine);
  return turned;
}

bool ContourCalls::turn_lines(const Block& called, Code code) {
  const Block block = called;
  if (!block.has('p') || !block.has('q')) return set_up_turning(context_, block, code);
  if (reader_ != nullptr) {
    return context_.faults.fail("lathe-contour-motion", "a lathe cycle in the contour of another", "call it outside",
                                block.column_of(GGroup::motion));
  }
  const Place place = flow_.place_of_fault(), behind = flow_.here();
  std::vector<ContourElement> contour;
  const bool read = read_lines(block, code == kLatheFinish, contour);
  if (code == kLatheFinish) flow_.go_to(behind);
  flow_.blame(place);
  if (!read) return false;
  WorkBudget budget(kMostSteps);
  const bool turned = run_turning_cycle(context_, block, code, std::move(contour), budget);
  flow_.add_work((kMostSteps - budget.left()) / kStepsOfALine);
  return turned;
}

bool ContourCalls::read_lines(const Block& block, bool before, std::vector<ContourElement>& contour) {
  Place begin;
  std::size_t last_line = 0;
  if (!flow_.find_contour(block.of('p'), block.of('q'), before, begin, last_line)) {
    return context_.faults.fail(
        "lathe-contour-lines", fmt::format("there are no lines N{:g} to N{:g}", block.of('p'), block.of('q')),
        "P and Q are the numbers of the first and the last line of the contour", block.column_of('p'));
  }
  const std::size_t depth = flow_.depth(), errors = log_.errors();
  const Position position = context_.state.position, programmed = context_.state.compensation.programmed;
  LatheContourReader reader(context_, position);
  reader_ = &reader;
  flow_.go_to(begin);
  while (flow_.depth() == depth && flow_.line_number() < last_line && run_next_line_()) {
  }
  reader_ = nullptr;
  context_.state.position = position;
  context_.state.compensation.programmed = programmed;
  flow_.take_jumped();
  context_.state.modal.motion = context_.state.plain_motion = reader.motion();
  return log_.errors() == errors && reader.finish(contour);
}

bool ContourCalls::read_contour(const Block& block, const LatheCycle& cycle, std::vector<ContourElement>& contour) {
  if (reader_ != nullptr) {
    return context_.faults.fail("lathe-contour-motion", "a lathe cycle in the contour of another", "call it outside",
                                block.column_of(GGroup::motion));
  }
  const std::size_t depth = flow_.depth(), errors = log_.errors();
  const Position position = context_.state.position, programmed = context_.state.compensation.programmed;
  if (!flow_.call_sub(cycle.contour, block.column_of('q'))) return false;
  LatheContourReader reader(context_, cycle.start);
  reader_ = &reader;
  while (flow_.depth() > depth && run_next_line_()) {
  }
  reader_ = nullptr;
  context_.state.position = position;
  context_.state.compensation.programmed = programmed;
  flow_.take_jumped();
  context_.state.modal.motion = reader.motion();
  return log_.errors() == errors && flow_.depth() == depth && reader.finish(contour);
}

}  // namespace toolpace::nc
