/// CSV polylines.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "toolpace/nc/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto reading = toolpace::read_text({reinterpret_cast<const char*>(data), size}, "path.csv");
  if (!reading) return 0;
  const auto& m = reading->moves;
  if (m.end.size() != m.size() || m.feed.size() != m.size() || m.line.size() != m.size() || !m.start.allFinite())
    std::abort();
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (!m.end[i].allFinite() || !(m.feed[i] > 0.0)) std::abort();
  }
  return 0;
}
