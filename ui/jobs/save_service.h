#pragma once
/// Writes the program under edit in a worker; the file appears whole or not at all.

#include <QObject>
#include <QString>
#include <optional>

#include "jobs/background.h"
#include "jobs/regular_file.h"
#include "models/program_text.h"

namespace toolpace::ui {

class SaveService : public QObject {
  Q_OBJECT

 public:
  explicit SaveService(QObject* parent = nullptr);

  /// Precondition: not busy.
  /// @param state  number of the text (program_model.h), handed back with the news
  void start(const ProgramText& text, quint64 state, const QString& path);
  bool isBusy() const { return worker_.isBusy(); }

 signals:
  void saved(const QString& path, quint64 state, std::optional<toolpace::ui::FileStamp> stamp);
  void failed(const toolpace::Error& error, const QString& path);
  void busyChanged(bool busy);

 private:
  Background worker_;
};

}  // namespace toolpace::ui
