#include "toolpace/io/setpoint_reader.h"

#include <algorithm>
#include <array>

#include "toolpace/io/setpoint_format.h"
#include "toolpace/verify/setpoint_readers.h"

namespace toolpace {
namespace {

constexpr std::size_t kMagicBytes = 8;

const SetpointFormat& format_of_content(std::string_view begin, const std::filesystem::path& file) {
  for (const SetpointFormat& f : setpoint_formats()) {
    if (!f.magic.empty() && begin.starts_with(f.magic)) return f;
  }
  const SetpointFormat* named = format_of(file);
  return named && named->magic.empty() ? *named : setpoint_formats().front();
}

}  // namespace

Result<std::unique_ptr<SetpointFile>> open_setpoint_file(const std::filesystem::path& file, const Monitor& monitor) {
  auto input = InputFile::open(file, monitor);
  if (!input) return tl::unexpected(std::move(input.error()));
  const std::string name = file.string();
  if (input->size() == 0) {
    return tl::unexpected(detail::setpoints_error("setpoints-empty", "the file is empty", {name, 0, 0}));
  }
  std::array<char, kMagicBytes> begin = {};
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(begin.size(), input->size()));
  if (auto read = input->read(0, begin.data(), count); !read) return tl::unexpected(std::move(read.error()));
  return format_of_content({begin.data(), count}, file).read(std::move(*input), name);
}

}  // namespace toolpace
