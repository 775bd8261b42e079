#include "jobs/regular_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <cerrno>
#include <filesystem>

#include "toolpace/base/descriptor.h"
#include "toolpace/base/file_error.h"

namespace toolpace::ui {
namespace {

constexpr qsizetype kPiece = qsizetype{1} << 22;  // bytes between two looks at the monitor
constexpr qint64 kNsPerSecond = 1'000'000'000;

FileStamp stamp(const struct stat& info) {
  return {static_cast<qint64>(info.st_dev), static_cast<qint64>(info.st_ino), static_cast<qint64>(info.st_size),
          info.st_mtim.tv_sec * kNsPerSecond + info.st_mtim.tv_nsec};
}

Error trouble(int number, const QString& path, const char* action) {
  return file_error(number, std::filesystem::path(path.toStdString()), action);
}

Result<void> check_kind(const struct stat& info, const QString& path) {
  if (S_ISREG(info.st_mode)) return {};
  if (S_ISDIR(info.st_mode)) return tl::unexpected(trouble(EISDIR, path, "open"));
  return tl::unexpected(Error{ErrorKind::io,
                              "not-regular-file",
                              "cannot open this file: it is a pipe, a socket or a device",
                              "save what comes from it as a file and open that",
                              {path.toStdString(), 0, 0},
                              {}});
}

}  // namespace

std::optional<FileStamp> stamp_of(const QString& path) {
  struct stat info {};
  if (::stat(QFile::encodeName(path).constData(), &info) != 0) return std::nullopt;
  return stamp(info);
}

Result<void> check_regular_file(const QString& path) {
  struct stat info {};
  if (::stat(QFile::encodeName(path).constData(), &info) != 0) return tl::unexpected(trouble(errno, path, "open"));
  return check_kind(info, path);
}

Result<StampedBytes> read_regular_file(const QString& path, const Monitor& monitor) {
  // Looked at before it is opened, too: opening some devices alone does something.
  if (auto regular = check_regular_file(path); !regular) return tl::unexpected(regular.error());
  const auto descriptor = open_for_reading(QFileInfo(path).absoluteFilePath().toStdString());
  if (!descriptor) return tl::unexpected(descriptor.error());
  struct stat info {};
  if (::fstat(descriptor->value(), &info) != 0) return tl::unexpected(trouble(errno, path, "read"));
  if (auto regular = check_kind(info, path); !regular) return tl::unexpected(regular.error());
  StampedBytes content{{}, stamp(info)};
  content.bytes.reserve(content.stamp.bytes + 1);  // one more, to see the end
  for (qsizetype size = 0;;) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    content.bytes.resize(size + std::max<qsizetype>(std::min(kPiece, content.stamp.bytes - size), 1));
    const ssize_t count =
        ::read(descriptor->value(), content.bytes.data() + size, static_cast<std::size_t>(content.bytes.size() - size));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return tl::unexpected(trouble(errno, path, "read"));
    size += count;
    content.bytes.resize(size);
    if (count == 0) return content;
  }
}

}  // namespace toolpace::ui
