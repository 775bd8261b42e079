/// Setpoint files of every format: whatever the bytes, an error or a report. The first byte chooses the name's ending.

#include <array>
#include <cstdlib>

#include "scratch_file.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/machine/setup.h"
#include "toolpace/verify/verify.h"

namespace {

using namespace toolpace;

const std::filesystem::path& file_of(std::uint8_t choice) {
  static const std::array files = {fuzz::scratch_file(".csv"), fuzz::scratch_file(".halstream"),
                                   fuzz::scratch_file(".npy"), fuzz::scratch_file(".npz")};
  return files[choice % files.size()];
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto& path = file_of(data[0]);
  fuzz::fill(path, {reinterpret_cast<const char*>(data + 1), size - 1});
  const auto file = open_setpoint_file(path);
  if (!file) return 0;
  Machine machine = default_setup().machine;
  for (auto& axis : machine.axes) axis.speed = axis.acceleration = axis.jerk = 1e3;
  const auto report = verify(**file, machine);
  if (report && report->rows == 0) std::abort();
  return 0;
}
