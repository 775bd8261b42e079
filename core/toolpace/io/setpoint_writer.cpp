#include "toolpace/io/setpoint_writer.h"

#include <array>
#include <utility>

#include "toolpace/base/file_name.h"
#include "toolpace/io/writers.h"

namespace toolpace {
namespace {

struct FormatName {
  SetpointFormat format;
  std::string_view name;
};

constexpr std::array<FormatName, 5> kFormats = {{{SetpointFormat::csv, "csv"},
                                                 {SetpointFormat::npy, "npy"},
                                                 {SetpointFormat::npz, "npz"},
                                                 {SetpointFormat::halstream, "halstream"},
                                                 {SetpointFormat::semicolon, "semicolon"}}};

}  // namespace

std::optional<SetpointFormat> format_named(std::string_view name) {
  for (const auto& f : kFormats) {
    if (f.name == name) return f.format;
  }
  return {};
}

std::optional<SetpointFormat> format_of(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension.empty()) return SetpointFormat::csv;
  if (extension == ".csv" && inner_extension_of(file) == ".semicolon") return SetpointFormat::semicolon;
  return format_named(std::string_view(extension).substr(1));
}

Result<std::unique_ptr<SetpointWriter>> open_setpoint_writer(const std::filesystem::path& file,
                                                             const SetpointFileOptions& options,
                                                             const Monitor& monitor) {
  const auto format = options.format ? options.format : format_of(file);
  if (!format) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "setpoint-format-unknown",
                                "the extension '" + file.extension().string() + "' names no setpoint format",
                                "use .csv, .npy, .npz, .halstream or .semicolon.csv",
                                {file.string(), 0, 0},
                                {}});
  }
  const bool binary = *format == SetpointFormat::npy || *format == SetpointFormat::npz;
  auto out = OutputFile::create(file, binary ? OutputFile::Access::patched : OutputFile::Access::forward, monitor);
  if (!out) return tl::unexpected(out.error());
  if (*format == SetpointFormat::npy) return io_detail::make_npy_writer(std::move(*out), options);
  if (*format == SetpointFormat::npz) return io_detail::make_npz_writer(std::move(*out), options);
  return io_detail::make_text_writer(std::move(*out), *format, options);
}

}  // namespace toolpace
