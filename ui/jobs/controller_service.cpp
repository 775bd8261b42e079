#include "jobs/controller_service.h"

#include <QFileInfo>

#include "toolpace/base/part_monitor.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/run_on_controller.h"

namespace toolpace::ui {
namespace {

struct Driven {
  Planned motion;
  Diagnostics warnings;
};

Result<Driven> drive(const Document& document, const QString& settings, ReadOptions options, const Monitor& monitor) {
  ControllerRun run;
  auto read = read_controller_settings(settings.toStdString(), {}, {monitor.stop, {}});
  if (!read) return tl::unexpected(read.error());
  run.settings = std::move(*read);
  options.dialect = dialect_of(run.settings.controller);
  if (!document.path.isEmpty()) options.sub_paths.push_back(QFileInfo(document.path).absolutePath().toStdString());
  const QByteArray bytes = document.text.bytes();
  const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  run.program_name = document.name.toStdString();
  auto reading = read_text(text, run.program_name, options, part_of(monitor, 0.0, 0.2));
  if (!reading) return tl::unexpected(reading.error());
  run.program = std::make_shared<const Reading>(std::move(*reading));
  run.text = scan_program(text);
  auto driven = run_on_controller(run, part_of(monitor, 0.2, 0.8));
  if (!driven) return tl::unexpected(driven.error());
  const auto outcome = std::make_shared<const Outcome>(std::move(driven->outcome));
  Planned motion;
  motion.timeline = std::make_shared<const Timeline>(outcome);
  motion.scene = make_contour_scene(outcome);
  motion.series = make_profile_series(outcome);
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  return Driven{std::move(motion), run.settings.warnings};
}

}  // namespace

ControllerService::ControllerService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &ControllerService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!pending_) return emit busyChanged(false);
    const Request next = *std::exchange(pending_, std::nullopt);
    start(next);
  });
}

void ControllerService::run(std::shared_ptr<const Document> document, const QString& settings,
                            const ReadOptions& options) {
  ++latest_;
  const Request request{std::move(document), settings, options};
  if (worker_.isBusy()) {
    pending_ = request;
    worker_.cancel();
    return;
  }
  start(request);
  emit busyChanged(true);
}

void ControllerService::cancel() {
  ++latest_;
  pending_.reset();
  worker_.cancel();
}

void ControllerService::start(const Request& request) {
  const auto fail = [this, path = request.settings, number = latest_](const Error& error) {
    if (number == latest_) emit failed(error, path);
  };
  const auto work = [this, request, fail, number = latest_](const Monitor& monitor) -> Background::Delivery {
    auto found = drive(*request.document, request.settings, request.options, monitor);
    if (!found) return [fail, error = found.error()] { fail(error); };
    return [this, found = std::move(*found), number] {
      if (number == latest_) emit driven(found.motion, found.warnings);
    };
  };
  worker_.start(work, fail);
}

}  // namespace toolpace::ui
