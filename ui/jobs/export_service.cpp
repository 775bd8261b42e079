#include "jobs/export_service.h"

#include "jobs/setpoint_export.h"

namespace toolpace::ui {

ExportService::ExportService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &ExportService::progressed);
}

void ExportService::start(std::shared_ptr<const Outcome> outcome, const QString& file, const ExportOptions& options) {
  worker_.start([this, outcome = std::move(outcome), file, options](const Monitor& monitor) -> Background::Delivery {
    const auto rows = write_setpoints(*outcome, file, options, monitor);
    return [this, rows, file] {
      if (rows) {
        emit saved(file, *rows);
      } else {
        emit failed(rows.error(), file);
      }
    };
  });
}

}  // namespace toolpace::ui
