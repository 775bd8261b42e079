#pragma once
/// Reads programs in a worker.

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "jobs/background.h"
#include "jobs/regular_file.h"
#include "models/document.h"
#include "toolpace/base/result.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::ui {

/// A text to be read, and what it goes by.
struct ProgramSource {
  QString path;  ///< file that the text stands for, may be empty
  QString name;  ///< its extension chooses the format
  ProgramText text;
  std::optional<quint64> edited_state = {};  ///< as in Document
};

/// The latest request wins: an older one that still runs is cancelled and dropped.
class ReaderService : public QObject {
  Q_OBJECT

 public:
  explicit ReaderService(QObject* parent = nullptr);

  void readFile(const QString& path);
  /// @param name  its extension chooses the format
  void readText(const QByteArray& text, const QString& name);
  /// A text that is under edit. What leaves nothing to show (an empty program) is shown as a program with that problem.
  void readEdited(const ProgramSource& source);
  void cancel();
  bool isBusy() const { return worker_.isBusy(); }
  /// How all that is asked for from now on is read. The program's own folder is searched in any case.
  void setOptions(const ReadOptions& options) { options_ = options; }
  const ReadOptions& options() const { return options_; }

 signals:
  /// @param stamp  of the file that was read; none for texts
  void read(std::shared_ptr<const toolpace::ui::Document> document, std::optional<toolpace::ui::FileStamp> stamp);
  void failed(const toolpace::Error& error, const QString& path);
  void progressed(double fraction);
  void busyChanged(bool busy);

 private:
  struct Found {
    std::shared_ptr<const Document> document;
    std::optional<FileStamp> stamp;
  };
  using Read = std::function<Result<Found>(const Monitor&)>;

  static Result<Found> load(const QString& path, const ReadOptions& options, const Monitor& monitor);
  static Result<Found> understand(const ProgramSource& source, ReadOptions options, const Monitor& monitor);
  void submit(const QString& path, Read read);

  Background worker_;
  ReadOptions options_;
  std::function<void()> pending_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
