/// The scanner and the expression reader on one line of text.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "toolpace/nc/text/block_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toolpace::nc;
  if (size == 0) return 0;
  const bool fanuc = (data[0] & 1u) != 0;
  const std::string_view line(reinterpret_cast<const char*>(data) + 1, size - 1);
  Parameters parameters;
  if (fanuc) parameters.use_macro_variables();
  FaultSink faults;
  Scanner text(line);
  double value = 0.0;
  const bool good = ExpressionReader(parameters, faults, fanuc).read_value(text, value);
  if (good != faults.empty() || (good && std::isinf(value)) || (good && !fanuc && std::isnan(value))) std::abort();

  faults.clear();
  Scanner again(line);
  Block block;
  BlockReader reader(parameters, faults, rules_of(fanuc ? toolpace::Dialect::fanuc : toolpace::Dialect::linuxcnc));
  if (!reader.read(again, block) && faults.empty()) std::abort();
  return 0;
}
