/// Machine files: whatever the text, an error or a setup that can be written and read back.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "toolpace/machine/setup.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto setup = toolpace::parse_setup(text, "fuzz.toml");
  if (!setup) return 0;
  const auto text_again = toolpace::format_setup(*setup);
  if (!text_again) std::abort();
  const auto again = toolpace::parse_setup(*text_again, "again.toml");
  if (!again || !toolpace::is_same_file(*again, *setup)) std::abort();
  return 0;
}
