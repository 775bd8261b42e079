#include "toolpace/verify/setpoint_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "toolpace/base/file_name.h"
#include "toolpace/verify/setpoint_formats.h"

namespace toolpace {
namespace {

constexpr std::size_t kMagicBytes = 6;

}  // namespace

void SetpointRows::clear() {
  first = 0;
  count = 0;
  for (auto* column : {&time, &speed, &acceleration, &jerk}) column->clear();
  for (auto& column : position) column.clear();
  for (auto& order : derivative) {
    for (auto& column : order) column.clear();
  }
  line.clear();
}

namespace verify_detail {

Error setpoints_error(const char* code, std::string message, Location where, std::string remedy) {
  return {ErrorKind::input, code, std::move(message), std::move(remedy), std::move(where), {}};
}

}  // namespace verify_detail

Result<std::unique_ptr<SetpointFile>> open_setpoint_file(const std::filesystem::path& file, const Monitor& monitor) {
  auto input = InputFile::open(file, monitor);
  if (!input) return tl::unexpected(std::move(input.error()));
  const std::string name = file.string();
  if (input->size() == 0) {
    return tl::unexpected(verify_detail::setpoints_error("setpoints-empty", "the file is empty", {name, 0, 0}));
  }
  std::array<char, kMagicBytes> begin = {};
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(begin.size(), input->size()));
  if (auto read = input->read(0, begin.data(), count); !read) return tl::unexpected(std::move(read.error()));
  const std::string_view magic(begin.data(), count);
  if (magic.starts_with("\x93NUMPY")) return verify_detail::open_npy(std::move(*input), name);
  if (magic.starts_with("PK\x03\x04")) return verify_detail::open_npz(std::move(*input), name);
  return verify_detail::open_text(std::move(*input), name, extension_of(file) == ".halstream");
}

}  // namespace toolpace
