#include "toolpace/io/setpoint_writer.h"

#include <utility>

namespace toolpace {

Result<std::unique_ptr<SetpointWriter>> open_setpoint_writer(const std::filesystem::path& file,
                                                             const SetpointFileOptions& options,
                                                             const Monitor& monitor) {
  const SetpointFormat* format = options.format ? options.format : format_of(file);
  if (!format) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "setpoint-format-unknown",
                                "the extension '" + file.extension().string() + "' names no setpoint format",
                                "use " + setpoint_suffixes(),
                                {file.string(), 0, 0},
                                {}});
  }
  if (options.tip_of && !format->names_columns) {
    return tl::unexpected(
        Error{ErrorKind::usage,
              "setpoint-columns-unnamed",
              std::string(format->suffix) + " has no names of columns, so that there is no room for the tip",
              "write .csv or .semicolon.csv",
              {file.string(), 0, 0},
              {}});
  }
  auto out = OutputFile::create(file, format->access, monitor);
  if (!out) return tl::unexpected(out.error());
  return format->write(std::move(*out), options);
}

}  // namespace toolpace
