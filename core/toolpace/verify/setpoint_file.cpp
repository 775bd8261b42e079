#include "toolpace/verify/setpoint_file.h"

#include "toolpace/verify/setpoint_formats.h"

namespace toolpace {

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

Result<std::unique_ptr<SetpointFile>> open_setpoint_file(const std::filesystem::path& file) {
  auto mapped = MappedFile::open(file);
  if (!mapped) return tl::unexpected(mapped.error());
  const std::string name = file.string();
  const std::string_view bytes = mapped->bytes();
  if (bytes.empty()) {
    return tl::unexpected(verify_detail::setpoints_error("setpoints-empty", "the file is empty", {name, 0, 0}));
  }
  if (bytes.starts_with("\x93NUMPY")) return verify_detail::open_npy(std::move(*mapped), name);
  if (bytes.starts_with("PK\x03\x04")) return verify_detail::open_npz(std::move(*mapped), name);
  return verify_detail::open_text(std::move(*mapped), name, file.extension() == ".halstream");
}

}  // namespace toolpace
