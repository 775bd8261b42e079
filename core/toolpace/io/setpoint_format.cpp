#include "toolpace/io/setpoint_format.h"

#include <array>

#include "toolpace/base/file_name.h"
#include "toolpace/io/writers.h"
#include "toolpace/verify/setpoint_readers.h"

namespace toolpace {
namespace {

using Access = OutputFile::Access;

constexpr std::array<SetpointFormat, 5> kFormats = {
    {{"csv", ".csv", "Comma-separated", Access::forward, true, detail::make_csv_writer, "", detail::open_text},
     {"npy", ".npy", "NumPy array", Access::patched, false, detail::make_npy_writer, "\x93NUMPY", detail::open_npy},
     {"npz", ".npz", "NumPy archive", Access::patched, false, detail::make_npz_writer, "PK\x03\x04", detail::open_npz},
     {"halstream", ".halstream", "LinuxCNC halstreamer", Access::forward, false, detail::make_halstream_writer, "",
      detail::open_halstream},
     {"semicolon", ".semicolon.csv", "Semicolons", Access::forward, true, detail::make_semicolon_writer, "",
      detail::open_text}}};

}  // namespace

std::span<const SetpointFormat> setpoint_formats() { return kFormats; }

const SetpointFormat* format_named(std::string_view id) {
  for (const SetpointFormat& f : kFormats) {
    if (f.id == id) return &f;
  }
  return nullptr;
}

const SetpointFormat* format_of(const std::filesystem::path& file) {
  const std::string outer = extension_of(file), whole = inner_extension_of(file) + outer;
  if (outer.empty()) return &kFormats.front();
  const SetpointFormat* found = nullptr;
  for (const SetpointFormat& f : kFormats) {
    if (f.suffix == whole) return &f;
    if (f.suffix == outer) found = &f;
  }
  return found;
}

std::string setpoint_suffixes() {
  std::string text;
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    text += std::string(i == 0 ? "" : i + 1 < kFormats.size() ? ", " : " or ") + std::string(kFormats[i].suffix);
  }
  return text;
}

}  // namespace toolpace
