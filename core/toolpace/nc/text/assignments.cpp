#include "toolpace/nc/text/assignments.h"

#include <fmt/format.h>

namespace toolpace::nc {

bool Assignments::read(Scanner& text) {
  Assignment assignment;
  assignment.column = text.column();
  text.take();
  if (text.peek() != '<' && !ExpressionReader::begins_value(text)) {
    return faults_.fail("number-expected", "'#' without the number of a parameter",
                        "write #1 = value or #<name> = value; comments stand in ( ) or behind ;", assignment.column);
  }
  if (!expressions_.read_target(text, assignment.target)) return false;
  if (text.peek() != '=') {
    return faults_.fail("equals-missing", "'=' is missing after the parameter", "write #number = value", text.column());
  }
  text.take();
  // A name begins to exist, with value 0, as soon as an assignment mentions it.
  const auto& target = assignment.target;
  if (target.index < 0 && !parameters_.named(target.name)) parameters_.set_named(target.name, 0.0);
  if (!expressions_.read_assigned(text, assignment.value)) return false;
  list_.push_back(std::move(assignment));
  return true;
}

// All at the end of the block: within it, the old values count.
bool Assignments::make() {
  for (const auto& assignment : list_) {
    const auto& target = assignment.target;
    if (target.index >= 0) {
      if (parameters_.is_read_only(target.index)) {
        return faults_.fail("parameter-read-only", fmt::format("parameter #{} cannot be assigned", target.index),
                            "use another parameter", assignment.column);
      }
      parameters_.set_numbered(target.index, assignment.value);
      continue;
    }
    if (parameters_.is_state_name(target.name)) {
      return faults_.fail("parameter-read-only", fmt::format("#<{}> is kept by the controller", target.name),
                          "use another name", assignment.column);
    }
    if (!parameters_.set_named(target.name, assignment.value)) {
      return faults_.fail("too-many-names", fmt::format("more than {} named parameters", kMostNames), "use fewer names",
                          assignment.column);
    }
  }
  return true;
}

}  // namespace toolpace::nc
