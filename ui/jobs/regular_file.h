#pragma once
/// Files as the window opens them: never a pipe or a device, which could block it or have no end.

#include <QByteArray>
#include <QString>
#include <optional>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"

namespace toolpace::ui {

/// Two looks at a file that give the same stamp saw the same content.
struct FileStamp {
  qint64 device = 0, inode = 0, bytes = 0, modified_ns = 0;
  bool operator==(const FileStamp&) const = default;
};

/// A whole file as it was read, and which file that was.
struct StampedBytes {
  QByteArray bytes;
  FileStamp stamp;  ///< taken before reading: of a file that changes meanwhile it is out of date
};

/// Of the file behind links; none where there is no such file.
std::optional<FileStamp> stamp_of(const QString& path);

/// Errors (io): as of file_error(), and "not-regular-file" for pipes, sockets and devices.
Result<void> check_regular_file(const QString& path);

/// The whole file, without ever waiting for a writer. Errors (io): those of check_regular_file, and cancelled.
Result<StampedBytes> read_regular_file(const QString& path, const Monitor& monitor = {});

}  // namespace toolpace::ui
