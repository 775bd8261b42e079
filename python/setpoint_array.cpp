#include "setpoint_array.h"

#include "toolpace/io/npy_format.h"
#include "toolpace/io/setpoint_table.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::python {

Result<SetpointArray> setpoint_array(const Outcome& outcome, const std::optional<Chain>& tip_of,
                                     const Monitor& monitor) {
  Sampler sampler = sampler_of(outcome);
  SetpointTable table(false, tip_of);
  SetpointArray array;
  array.lines.reserve(sampler.rows());
  std::size_t filled = 0;
  for (Setpoints chunk; sampler.next(chunk);) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (auto loaded = table.load(chunk); !loaded) return tl::unexpected(loaded.error());
    if (array.values.empty()) array.values.resize(sampler.rows() * table.names().size());
    detail::npy::pack_rows(table.columns(), 0, table.rows(), array.values.data() + filled);
    filled += table.rows() * table.names().size();
    array.lines.insert(array.lines.end(), table.lines(), table.lines() + table.rows());
  }
  array.names = table.names();
  return array;
}

}  // namespace toolpace::python
