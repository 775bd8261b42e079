#include "toolpace/io/output_guard.h"

#include <unistd.h>

#include <optional>

#include "toolpace/base/file_identity.h"

namespace toolpace {
namespace {

std::optional<FileIdentity> identity_of_role(const FileRole& role, int standard) {
  if (role.file.empty()) return {};
  return role.file == "-" ? identity_of(standard) : identity_of(role.file);
}

Error guard_error(const char* code, std::string message, std::string remedy, const FileRole& output) {
  return {ErrorKind::usage, code, std::move(message), std::move(remedy), {output.file.string(), 0, 0}, {}};
}

}  // namespace

Result<void> check_outputs(const std::vector<FileRole>& outputs, const std::vector<FileRole>& inputs) {
  std::vector<std::optional<FileIdentity>> written;
  for (const FileRole& output : outputs) {
    const auto here = identity_of_role(output, STDOUT_FILENO);
    for (const FileRole& input : inputs) {
      if (!here || here != identity_of_role(input, STDIN_FILENO)) continue;
      return tl::unexpected(guard_error("output-is-input",
                                        output.what + " is the same file as " + input.what + ", which would be lost",
                                        "write to another file", output));
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
      if (!here || here != written[i]) continue;
      return tl::unexpected(guard_error("output-twice", output.what + " is the same file as " + outputs[i].what,
                                        "write to different files", output));
    }
    written.push_back(here);
  }
  return {};
}

}  // namespace toolpace
