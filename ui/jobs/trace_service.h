#pragma once
/// Reads a measured trace and lays it beside a plan, in a worker.

#include <QObject>
#include <functional>
#include <memory>

#include "drawing/measured_trace.h"
#include "jobs/background.h"
#include "toolpace/trace/trace.h"

namespace toolpace::ui {

/// A newer request replaces an older one, whose result never arrives. The trace is read once, and kept.
class TraceService : public QObject {
  Q_OBJECT

 public:
  explicit TraceService(QObject* parent = nullptr);

  /// @param outcome  null: compared as soon as there is a plan
  void open(const QString& path, const TraceOptions& options, std::shared_ptr<const Outcome> outcome);
  /// Lays the trace that is open beside another plan.
  void compareWith(std::shared_ptr<const Outcome> outcome);
  void close();
  bool isOpen() const { return !path_.isEmpty(); }
  const QString& path() const { return path_; }
  bool isBusy() const { return worker_.isBusy() || next_; }

 signals:
  void compared(std::shared_ptr<const toolpace::ui::MeasuredTrace> trace);
  void failed(const toolpace::Error& error, const QString& path);
  void progressed(double fraction);
  void busyChanged(bool busy);

 private:
  void submit();

  Background worker_;
  std::function<void()> next_;
  quint64 latest_ = 0;
  QString path_;
  TraceOptions options_;
  std::shared_ptr<const Trace> trace_;  // once it was read
  std::shared_ptr<const Outcome> outcome_;
};

/// Pure, for the worker. Errors: those of compare(); input (setpoints-empty) for a plan that moves nothing.
Result<std::shared_ptr<const MeasuredTrace>> measure_against(const Trace& trace, std::shared_ptr<const Outcome> outcome,
                                                             const Monitor& monitor);

}  // namespace toolpace::ui
