#include "jobs/export_service.h"

#include "jobs/setpoint_export.h"

namespace toolpace::ui {

ExportService::ExportService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &ExportService::progressed);
}

void ExportService::start(std::shared_ptr<const Outcome> outcome, const QString& file, const ExportOptions& options) {
  const auto write = [this, outcome = std::move(outcome), file, options](const Monitor& monitor) {
    const auto rows = write_setpoints(*outcome, file, options, monitor);
    return [this, rows, file] {
      if (rows) {
        emit saved(file, *rows);
      } else {
        emit failed(rows.error(), file);
      }
    };
  };
  worker_.start(write, [this, file](const Error& error) { emit failed(error, file); });
}

}  // namespace toolpace::ui
