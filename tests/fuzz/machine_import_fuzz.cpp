/// Settings of controllers: whatever the text, an error or a machine that can be saved and opened again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "toolpace/machine/read_machine.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  using namespace toolpace;
  for (const auto& setup :
       {import_linuxcnc_ini(text, "fuzz.ini"), import_grbl_dump(text, "fuzz.txt"), parse_machine(text, "fuzz")}) {
    if (!setup) continue;
    const auto saved = format_setup(*setup);
    if (!saved) std::abort();
    const auto again = parse_setup(*saved, "again.toml");
    if (!again || !is_same_file(*again, *setup)) std::abort();
  }
  return 0;
}
