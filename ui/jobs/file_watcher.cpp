#include "jobs/file_watcher.h"

#include <QFileInfo>

namespace toolpace::ui {
namespace {

constexpr int kSettleMs = 150;  // a writer that writes in pieces is one change

}  // namespace

FileWatcher::FileWatcher(QObject* parent) : QObject(parent) {
  settle_.setSingleShot(true);
  settle_.setInterval(kSettleMs);
  connect(&settle_, &QTimer::timeout, this, &FileWatcher::look);
  const auto soon = [this] { settle_.start(); };
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, soon);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, soon);
}

void FileWatcher::watch(const QString& path, const std::optional<FileStamp>& known) {
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
  path_ = path;
  known_ = known;
  if (!path.isEmpty()) watcher_.addPaths({path, QFileInfo(path).absolutePath()});
  release();
}

void FileWatcher::release() {
  held_ = false;
  if (!path_.isEmpty()) settle_.start();  // it may have changed before it was watched
}

void FileWatcher::look() {
  const auto now = stamp_of(path_);
  if (held_ || path_.isEmpty() || !now) return;
  if (!watcher_.files().contains(path_)) watcher_.addPath(path_);
  if (now == known_) return;
  known_ = now;
  emit changed(path_);
}

}  // namespace toolpace::ui
