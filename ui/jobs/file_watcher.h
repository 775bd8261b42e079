#pragma once
/// Tells when a file was written to or replaced.

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace toolpace::ui {

/// Many editors save by renaming a new file over the old one, which QFileSystemWatcher loses sight of; so the folder is
/// watched too and the file re-added.
class FileWatcher : public QObject {
  Q_OBJECT

 public:
  explicit FileWatcher(QObject* parent = nullptr);

  void watch(const QString& path);  ///< empty = nothing

 signals:
  void changed(const QString& path);

 private:
  void look();

  QFileSystemWatcher watcher_;
  QTimer settle_;
  QString path_;
  QDateTime modified_;
  qint64 size_ = -1;
};

}  // namespace toolpace::ui
