/// Setpoint files of every format: whatever the bytes, an error or a report. The first byte chooses the name's ending.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "toolpace/machine/setup.h"
#include "toolpace/verify/verify.h"

namespace {

using namespace toolpace;

const std::filesystem::path& file_of(bool halstream) {
  const auto name = [](const char* ending) {
    return std::filesystem::temp_directory_path() / ("toolpace_fuzz_" + std::to_string(getpid()) + ending);
  };
  static const std::filesystem::path plain = name(".csv"), stream = name(".halstream");
  return halstream ? stream : plain;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto& path = file_of((data[0] & 1U) != 0);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  const auto file = open_setpoint_file(path);
  if (!file) return 0;
  Machine machine = default_setup().machine;
  for (auto& axis : machine.axes) axis.speed = axis.acceleration = axis.jerk = 1e3;
  const auto report = verify(**file, machine);
  if (report && report->rows == 0) std::abort();
  return 0;
}
