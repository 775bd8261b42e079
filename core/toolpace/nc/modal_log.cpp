#include "toolpace/nc/modal_log.h"

#include <algorithm>
#include <iterator>

#include "toolpace/nc/text/words.h"

namespace toolpace {
namespace {

constexpr std::size_t kMostStates = 0xFFFF;
constexpr std::size_t kLookBack = 64;  // distinct states compared with, newest first

}  // namespace

std::string ModalSnapshot::work_offset() const {
  if (system > 9) return "G54.1 P" + std::to_string(system - 9);
  return nc::code_text('G', static_cast<std::int16_t>(system <= 6 ? 530 + 10 * system : 590 + (system - 6)));
}

std::string ModalSnapshot::codes() const {
  std::string text;
  for (const std::int16_t code : {motion, plane, units, distance, arc_distance, feed_mode})
    text += nc::code_text('G', code) + ' ';
  text += work_offset();
  for (const std::int16_t code : {compensation, tool_length, path_control, spindle_mode, retract})
    text += ' ' + nc::code_text('G', code);
  if (lathe_diameter == 70) text += " G7";
  return text;
}

void ModalLog::record(std::size_t file, std::size_t line, const ModalSnapshot& snapshot) {
  ModalSnapshot state = snapshot;
  state.feed = 0.0;
  std::size_t index = states_.size();
  const std::size_t oldest = states_.size() > kLookBack ? states_.size() - kLookBack : 0;
  for (std::size_t i = states_.size(); i-- > oldest;) {
    if (states_[i] == state) {
      index = i;
      break;
    }
  }
  if (index == states_.size()) {
    if (states_.size() >= kMostStates) return;
    states_.push_back(state);
  }
  in_order_ = in_order_ && file == 0 && (changes_.empty() || changes_.back().line <= line);
  // While lines run in order, a line that changes nothing need not be listed.
  if (in_order_ && !changes_.empty() && changes_.back().state == index && changes_.back().feed == snapshot.feed) return;
  changes_.push_back({static_cast<std::uint32_t>(line), static_cast<std::uint16_t>(file),
                      static_cast<std::uint16_t>(index), snapshot.feed});
}

std::optional<ModalSnapshot> ModalLog::at(std::size_t line, std::size_t file) const {
  const Change* best = nullptr;
  if (in_order_ && file == 0) {
    const auto after =
        std::upper_bound(changes_.begin(), changes_.end(), line,
                         [](std::size_t at_line, const Change& change) { return at_line < change.line; });
    if (after != changes_.begin()) best = &*std::prev(after);
  } else {
    for (const auto& change : changes_) {
      if (change.file == file && change.line <= line && (best == nullptr || change.line >= best->line)) best = &change;
    }
  }
  if (best == nullptr) return std::nullopt;
  ModalSnapshot snapshot = states_[best->state];
  snapshot.feed = best->feed;
  return snapshot;
}

}  // namespace toolpace
