#include "toolpace/base/file_error.h"

#include <cerrno>
#include <string>
#include <system_error>

#include "toolpace/base/monitor.h"

namespace toolpace {
namespace {

struct Meaning {
  const char* code;
  const char* what;
  const char* remedy;
};

Meaning meaning(int number) {
  switch (number) {
    case ENOENT:
    case ENOTDIR: return {"file-not-found", "there is no such file or directory", "check the path"};
    case EISDIR: return {"is-directory", "it is a directory", "name a file"};
    case EACCES:
    case EPERM:
    case EROFS: return {"no-permission", "permission is denied", "check the rights of the file and its directory"};
    case ENOSPC:
    case EDQUOT: return {"disk-full", "no space is left", "free space or write elsewhere"};
    case EPIPE: return {"closed-pipe", "the reader closed the pipe", ""};
    case EFBIG: return {"file-too-large", "the file would be too large here", "write elsewhere or split the program"};
    default: return {"file-trouble", nullptr, ""};
  }
}

}  // namespace

Error file_error(int number, const std::filesystem::path& file, std::string_view action) {
  if (number == ECANCELED) return cancelled_error();
  const Meaning m = meaning(number);
  const std::string what = m.what != nullptr ? m.what : std::generic_category().message(number);
  return {ErrorKind::io,         m.code, "cannot " + std::string(action) + " this file: " + what, m.remedy,
          {file.string(), 0, 0}, {}};
}

}  // namespace toolpace
