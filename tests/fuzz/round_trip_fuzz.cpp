/// Setpoints of any numbers, written in any format and read back: the same numbers. Bytes are numbers; the first chooses format
/// and axes.

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "scratch_file.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/io/setpoint_writer.h"

namespace {

using namespace toolpace;

struct Format {
  const char* ending;
  bool has_lines;
};
constexpr std::array kFormats = {Format{".csv", true}, Format{".npy", false}, Format{".npz", true},
                                 Format{".halstream", false}, Format{".semicolon.csv", true}};

/// Rows of three or six positions and the profile, as many as there are bytes for.
Setpoints setpoints_of(const std::uint8_t* data, std::size_t size, bool rotary) {
  const std::size_t axes = rotary ? kAxisCount : 3, width = axes + 3;
  Setpoints setpoints;
  for (std::size_t row = 0; row < size / (8 * width); ++row) {
    const auto number = [&](std::size_t column) {
      double value = 0;
      std::memcpy(&value, data + 8 * (row * width + column), sizeof(value));
      return value;
    };
    for (std::size_t axis = 0; axis < axes; ++axis) setpoints.position[axis].push_back(number(axis));
    setpoints.speed.push_back(number(axes));
    setpoints.acceleration.push_back(number(axes + 1));
    setpoints.jerk.push_back(number(axes + 2));
    setpoints.line.push_back(data[8 * row * width]);
  }
  return setpoints;
}

/// Angles pass through degrees.
bool is_same(double written, double read, bool angle) {
  return angle ? std::abs(written - read) <= 4e-16 * std::abs(written) + 1e-300 : written == read;
}

bool are_same(const std::vector<double>& written, const std::vector<double>& read, bool angle = false) {
  if (written.size() != read.size()) return false;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (!is_same(written[k], read[k], angle)) return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Format& format = kFormats[data[0] % kFormats.size()];
  const Setpoints written = setpoints_of(data + 1, size - 1, data[0] / kFormats.size() % 2 == 1);
  if (written.size() == 0) return 0;
  const auto name = fuzz::scratch_file(format.ending);
  auto writer = open_setpoint_writer(name);
  if (!writer) std::abort();
  if (!(*writer)->write(written)) return 0;  // not finite
  if (!(*writer)->finish()) std::abort();
  auto file = open_setpoint_file(name);
  if (!file) std::abort();
  SetpointRows rows;
  const auto count = (*file)->read(rows, written.size() + 1);
  if (!count || *count != written.size()) std::abort();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const bool is_read = !rows.position[axis].empty() && !written.position[axis].empty();
    if (is_read && !are_same(written.position[axis], rows.position[axis], is_rotary(axis))) std::abort();
  }
  if (!rows.speed.empty() && !are_same(written.speed, rows.speed)) std::abort();
  if (format.has_lines && rows.line != written.line) std::abort();
  return 0;
}
