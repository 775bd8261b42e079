#pragma once
/// Keeps the modal log while a program runs.

#include <optional>
#include <unordered_set>

#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/modal_log.h"
#include "toolpace/nc/state.h"

namespace toolpace::nc {

class ModalRecorder {
 public:
  explicit ModalRecorder(ModalLog& log) : log_(log) {}

  /// Notes what is modal after the line taken last, if it has changed.
  void record(const State& state, const Flow& flow);

 private:
  ModalLog& log_;
  std::optional<Modal> last_;  ///< at the last entry
  int last_tool_ = 0;
  std::unordered_set<std::uint64_t> places_;  ///< noted once lines are run out of order
};

}  // namespace toolpace::nc
