#pragma once
/// Parameters that mirror what the machine is in: positions, modes, the tool.

#include <optional>
#include <string_view>

#include "toolpace/nc/dialects/rules.h"
#include "toolpace/nc/flow/flow.h"
#include "toolpace/nc/state.h"

namespace toolpace::nc {

class MachineValues {
 public:
  MachineValues(const State& state, const Flow& flow, const DialectRules& rules)
      : state_(state), flow_(flow), rules_(rules) {}

  /// None where parameter #index is an ordinary one.
  std::optional<double> numbered(int index) const;
  /// None where #<name> is an ordinary one. `name` is folded.
  std::optional<double> named(std::string_view name) const;

 private:
  const State& state_;
  const Flow& flow_;
  const DialectRules& rules_;
};

}  // namespace toolpace::nc
