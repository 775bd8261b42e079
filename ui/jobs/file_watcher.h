#pragma once
/// Tells when a file was written to or replaced.

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <optional>

#include "jobs/regular_file.h"

namespace toolpace::ui {

/// Many editors save by renaming a new file over the old one, which QFileSystemWatcher loses sight of; so the folder is
/// watched too and the file re-added.
class FileWatcher : public QObject {
  Q_OBJECT

 public:
  explicit FileWatcher(QObject* parent = nullptr);

  /// @param path  empty = nothing
  /// @param known  the file as it was read or written; what it is now, if that is something else, is a change
  void watch(const QString& path, const std::optional<FileStamp>& known);
  /// While the file is written here: what happens meanwhile is looked at by the next watch().
  void hold() { held_ = true; }
  void release();

 signals:
  void changed(const QString& path);

 private:
  void look();

  QFileSystemWatcher watcher_;
  QTimer settle_;
  QString path_;
  std::optional<FileStamp> known_;
  bool held_ = false;
};

}  // namespace toolpace::ui
