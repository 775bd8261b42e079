#include "jobs/controller_service.h"

#include <fmt/format.h>

#include <QFileInfo>

#include "toolpace/base/axis_unit.h"
#include "toolpace/base/part_monitor.h"
#include "toolpace/controller/refusals.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/run_on_controller.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kMostRefusals = 1000;  // in the list of problems

/// Of another file than the program: its name stands in the message, and its lines mean nothing here.
Diagnostic of_settings(Diagnostic warning, const QString& path) {
  warning.message = QFileInfo(path).fileName().toStdString() + ": " + warning.message;
  warning.where.line = 0;
  return warning;
}

Diagnostic as_diagnostic(const AxisExcess& e, Controller controller) {
  const AxisUnit& unit = axis_unit(e.axis);
  const bool is_speed = e.of == AxisExcess::Of::speed;
  return {Severity::warning,
          "controller-over-limit",
          fmt::format("{} drives {} to {:.4g} {}, {:.3g} times its limit", controller_title(controller),
                      kAxisNames[e.axis], e.value / unit.size, unit.symbol[is_speed ? 1 : 2], e.value / e.limit),
          "",
          {"", e.line, 0},
          {}};
}

void add(Diagnostics& list, const Diagnostics& more) { list.insert(list.end(), more.begin(), more.end()); }

Diagnostics problems_of(const Controlled& run, const std::vector<AxisExcess>& excess, const std::string& name) {
  const Controller controller = run.prediction.controller;
  Diagnostics problems;
  const auto refused = refusals(controller, *run.reading);
  for (std::size_t i = 0; i < std::min(refused.size(), kMostRefusals); ++i) {
    problems.push_back(
        {Severity::error,
         "controller-refuses",
         fmt::format("{} answers {}: {}", controller_title(controller), refused[i].code(), refused[i].message),
         "",
         {"", refused[i].line, 0},
         {}});
  }
  for (const AxisExcess& e : excess) problems.push_back(as_diagnostic(e, controller));
  add(problems, run.prediction.warnings);
  add(problems, not_counted(*run.text, run.asked->settings, name));
  for (const Diagnostic& warning : run.asked->settings.warnings) {
    problems.push_back(of_settings(warning, run.asked->path));
  }
  return problems;
}

std::vector<double> by_line(const std::vector<double>& row_time, const Moves& moves) {
  std::vector<double> times;
  for (std::size_t row = 0; row < row_time.size() && row < moves.size(); ++row) {
    if (moves.file[row] != 0) continue;
    const std::size_t line = moves.line[row];
    if (line >= times.size()) times.resize(line + 1);
    times[line] += row_time[row];
  }
  return times;
}

/// The motion that a controller makes of it, ready to be drawn.
Planned drawn(Outcome motion) {
  const auto outcome = std::make_shared<const Outcome>(std::move(motion));
  return {std::make_shared<const Timeline>(outcome), make_contour_scene(outcome), make_profile_series(outcome), {}};
}

Result<std::shared_ptr<const Controlled>> drive(ControllerRun run, Controlled found, const Monitor& monitor) {
  run.options.keeps_blocks = true;
  std::vector<AxisExcess> excess;
  if (run.settings.controller == Controller::linuxcnc) {
    auto prediction = predict(*run.program, run.text, run.settings, run.options, monitor);
    if (!prediction) return tl::unexpected(prediction.error());
    found.prediction = std::move(*prediction);
  } else {
    auto driven = run_on_controller(run, monitor);
    if (!driven) return tl::unexpected(driven.error());
    auto over = axes_over_limits(driven->outcome, {monitor.stop, {}});
    if (!over) return tl::unexpected(over.error());
    excess = std::move(*over);
    found.motion = drawn(std::move(driven->outcome));
    found.prediction = std::move(driven->prediction);
    found.prediction.stages = {};
  }
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  found.line_time = by_line(found.prediction.row_time, run.program->moves);
  found.problems = problems_of(found, excess, run.program_name);
  return std::make_shared<const Controlled>(std::move(found));
}

}  // namespace

ControllerService::ControllerService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &ControllerService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!pending_) return emit busyChanged(false);
    start(*std::exchange(pending_, std::nullopt), latest_);
  });
}

quint64 ControllerService::submit(std::shared_ptr<const Document> document, SharedControllerText settings,
                                  const ReadOptions& options, const PredictOptions& supply) {
  const Request request{std::move(document), std::move(settings), options, supply};
  ++latest_;
  if (worker_.isBusy()) {
    pending_ = request;
  } else {
    start(request, latest_);
    emit busyChanged(true);
  }
  return latest_;
}

void ControllerService::cancel() {
  pending_.reset();
  worker_.cancel();
}

/// The program as this controller reads it, unless it was read so already.
Result<ControllerService::Read> ControllerService::read(const Request& request, const Read& before,
                                                        const Monitor& monitor) {
  const Document& document = *request.document;
  const Dialect dialect = dialect_of(request.settings->settings.controller);
  if (before.document == request.document && before.dialect == dialect) return before;
  ReadOptions options = request.options;
  options.dialect = dialect;
  if (!document.path.isEmpty()) options.sub_paths.push_back(QFileInfo(document.path).absolutePath().toStdString());
  const QByteArray bytes = document.text.bytes();
  const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  auto reading = read_text(text, document.name.toStdString(), options, monitor);
  if (!reading) return tl::unexpected(reading.error());
  return Read{request.document, dialect, std::make_shared<const Reading>(std::move(*reading)),
              std::make_shared<const toolpace::ProgramText>(scan_program(text))};
}

void ControllerService::start(const Request& request, quint64 generation) {
  const auto fail = [this, generation](const Error& error) { emit failed(error, generation); };
  const auto work = [this, request, fail, generation, before = last_](const Monitor& monitor) -> Background::Delivery {
    auto program = read(request, before, part_of(monitor, 0.0, 0.3));
    if (!program) return [fail, error = program.error()] { fail(error); };
    ControllerRun run{program->reading, request.document->name.toStdString(), *program->text,
                      request.settings->settings, request.supply};
    Controlled found{request.settings, request.supply, program->reading, program->text, {}, {}, {}, {}};
    auto driven = drive(std::move(run), std::move(found), part_of(monitor, 0.3, 1.0));
    return [this, fail, generation, program = std::move(*program), driven = std::move(driven)] {
      last_ = program;
      if (!driven) return fail(driven.error());
      emit this->driven(*driven, generation);
    };
  };
  worker_.start(work, fail);
}

}  // namespace toolpace::ui
