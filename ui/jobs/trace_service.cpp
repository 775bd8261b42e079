#include "jobs/trace_service.h"

#include <QFileInfo>

#include "toolpace/sample/sampler.h"
#include "toolpace/trace/commanded_rows.h"

namespace toolpace::ui {
namespace {

Result<CommandedRows> rows_of(const Outcome& outcome, const Monitor& monitor) {
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, outcome.job->machine.period);
  CommandedRows commanded;
  for (Setpoints chunk; sampler.next(chunk);) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    commanded.append(chunk);
  }
  if (commanded.size() >= 2) return commanded;
  return tl::unexpected(
      Error{ErrorKind::input, "setpoints-empty", "the program moves no axis", "", {}, {}});
}

/// What is drawn of one row after another.
class Drawn {
 public:
  Drawn(const Trace& trace, const CommandedRows& commanded, MeasuredTrace& measured)
      : trace_(trace), commanded_(commanded), measured_(measured), actual_(std::make_shared<ErrorTrace>()) {
    measured_.actual = actual_;
  }

  void add(const ComparedRow& row) {
    Eigen::Vector3f at = Eigen::Vector3f::Zero(), offset = Eigen::Vector3f::Zero();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto& column = commanded_.position[axis];
      if (column.empty()) continue;
      const double asked = commanded_at(column, commanded_.period, row.time).position;
      if (axis < 3) at[static_cast<Eigen::Index>(axis)] = static_cast<float>(asked);
      const AxisComparison& compared = measured_.comparison.axis[axis];
      if (!compared.is_measured) continue;
      const auto error = static_cast<float>(trace_.rows.actual[axis][row.row] - compared.shift - asked);
      measured_.following[axis].push_back(error);
      if (axis < 3) offset[static_cast<Eigen::Index>(axis)] = error;
    }
    actual_->time.push_back(row.time);
    actual_->error.push_back(static_cast<float>(row.contour));
    actual_->commanded.push_back(at);
    actual_->offset.push_back(offset);
  }

 private:
  const Trace& trace_;
  const CommandedRows& commanded_;
  MeasuredTrace& measured_;
  std::shared_ptr<ErrorTrace> actual_;
};

}  // namespace

Result<std::shared_ptr<const MeasuredTrace>> measure_against(const Trace& trace, std::shared_ptr<const Outcome> outcome,
                                                             const Monitor& monitor) {
  const auto commanded = rows_of(*outcome, monitor);
  if (!commanded) return tl::unexpected(commanded.error());
  std::vector<ComparedRow> rows;
  auto comparison = compare(*commanded, trace, &rows, monitor);
  if (!comparison) return tl::unexpected(comparison.error());
  auto measured = std::make_shared<MeasuredTrace>();
  measured->name = QFileInfo(QString::fromStdString(trace.name)).fileName();
  measured->outcome = std::move(outcome);
  measured->comparison = std::move(*comparison);
  Drawn drawn(trace, *commanded, *measured);
  for (const ComparedRow& row : rows) drawn.add(row);
  return measured;
}

TraceService::TraceService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &TraceService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!next_) return emit busyChanged(false);
    std::exchange(next_, nullptr)();
  });
}

void TraceService::open(const QString& path, const TraceOptions& options, std::shared_ptr<const Outcome> outcome) {
  path_ = path;
  options_ = options;
  trace_.reset();
  outcome_ = std::move(outcome);
  submit();
}

void TraceService::compareWith(std::shared_ptr<const Outcome> outcome) {
  if (!isOpen() || outcome == outcome_) return;
  outcome_ = std::move(outcome);
  submit();
}

void TraceService::close() {
  ++latest_;
  next_ = nullptr;
  path_.clear();
  trace_.reset();
  outcome_.reset();
  worker_.cancel();
}

void TraceService::submit() {
  const quint64 number = ++latest_;
  const auto fail = [this, number, path = path_](const Error& error) {
    if (number == latest_ && error.kind != ErrorKind::cancelled) emit failed(error, path);
  };
  const auto work = [this, number, fail, path = path_, options = options_, known = trace_,
                     outcome = outcome_](const Monitor& monitor) -> Background::Delivery {
    std::shared_ptr<const Trace> trace = known;
    if (!trace) {
      auto read = read_trace(path.toStdString(), options, monitor);
      if (!read) return [fail, error = read.error()] { fail(error); };
      trace = std::make_shared<const Trace>(std::move(*read));
    }
    Result<std::shared_ptr<const MeasuredTrace>> measured;
    if (outcome) measured = measure_against(*trace, outcome, {monitor.stop, {}});
    return [this, number, fail, trace, measured] {
      if (number != latest_) return;
      trace_ = trace;
      if (!measured) return fail(measured.error());
      if (*measured) emit compared(*measured);
    };
  };
  const auto start = [this, work, fail] { worker_.start(work, fail); };
  if (worker_.isBusy()) {
    next_ = start;
    worker_.cancel();
    return;
  }
  start();
  emit busyChanged(true);
}

}  // namespace toolpace::ui
