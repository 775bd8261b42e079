#include "toolpace/verify/setpoint_file.h"

#include "toolpace/verify/setpoint_readers.h"

namespace toolpace {
void SetpointRows::clear() {
  first = 0;
  count = 0;
  for (auto* column : {&time, &speed, &acceleration, &jerk}) column->clear();
  for (auto& column : position) column.clear();
  for (auto* columns : {&tip, &tip_from}) {
    for (auto& column : *columns) column.clear();
  }
  for (auto& order : derivative) {
    for (auto& column : order) column.clear();
  }
  line.clear();
}

namespace detail {

Error setpoints_error(const char* code, std::string message, Location where, std::string remedy) {
  return {ErrorKind::input, code, std::move(message), std::move(remedy), std::move(where), {}};
}

}  // namespace detail

}  // namespace toolpace
