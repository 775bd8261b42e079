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

void FileWatcher::watch(const QString& path) {
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
  path_ = path;
  if (path.isEmpty()) return;
  const QFileInfo info(path);
  modified_ = info.lastModified();
  size_ = info.size();
  watcher_.addPaths({path, info.absolutePath()});
}

void FileWatcher::look() {
  const QFileInfo info(path_);
  if (path_.isEmpty() || !info.exists()) return;
  if (!watcher_.files().contains(path_)) watcher_.addPath(path_);
  if (info.lastModified() == modified_ && info.size() == size_) return;
  modified_ = info.lastModified();
  size_ = info.size();
  emit changed(path_);
}

}  // namespace toolpace::ui
