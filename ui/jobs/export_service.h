#pragma once
/// Writes the setpoints of a plan in a worker, with progress and cancel; the file appears whole or not at all.

#include <QObject>
#include <QString>
#include <memory>

#include "jobs/background.h"
#include "jobs/setpoint_export.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

class ExportService : public QObject {
  Q_OBJECT

 public:
  explicit ExportService(QObject* parent = nullptr);

  /// Precondition: not busy. The extension chooses the format.
  void start(std::shared_ptr<const Outcome> outcome, const QString& file, const ExportOptions& options = {});
  void cancel() { worker_.cancel(); }
  bool isBusy() const { return worker_.isBusy(); }

 signals:
  void progressed(double fraction);
  void saved(const QString& file, qulonglong rows);
  void failed(const toolpace::Error& error, const QString& file);

 private:
  Background worker_;
};

}  // namespace toolpace::ui
