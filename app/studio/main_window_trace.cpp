/// What a scope recorded: opening it, saying what its columns mean, laying it beside each plan.

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>

#include "main_window.h"
#include "models/problem_model.h"
#include "panels/trace_page.h"
#include "panels/transport_bar.h"
#include "trace_dialog.h"

namespace toolpace::studio {

void MainWindow::connectTrace() {
  connect(&tracer_, &ui::TraceService::compared, this, &MainWindow::takeTrace);
  connect(&tracer_, &ui::TraceService::failed, this, [this](const Error& error, const QString& path) {
    takeTrace(nullptr);
    trace_->showFailure(ui::message_text(error.code, error.message));
    showFailure(error, path);
  });
  connect(&tracer_, &ui::TraceService::busyChanged, trace_, &ui::TracePage::setBusy);
  connect(&tracer_, &ui::TraceService::progressed, transport_, &ui::TransportBar::setProgress);
  connect(trace_, &ui::TracePage::openRequested, this, &MainWindow::askTrace);
  connect(trace_, &ui::TracePage::columnsRequested, this, [this] { chooseTrace(tracer_.path()); });
  connect(trace_, &ui::TracePage::closeRequested, this, &MainWindow::closeTrace);
}

void MainWindow::askTrace() {
  const QString folder = QFileInfo(tracer_.isOpen() ? tracer_.path() : preferences_.last_program).absolutePath();
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a trace"), folder,
                                                    tr("Traces (*.csv *.txt *.tsv *.dat *.log);;All files (*)"));
  if (!path.isEmpty()) chooseTrace(path);
}

/// Shows first what its columns are taken for.
void MainWindow::chooseTrace(const QString& path) {
  forgetFailure();
  auto preview = preview_trace(path.toStdString());
  if (!preview) return showFailure(preview.error(), path);
  TraceDialog dialog(QFileInfo(path).fileName(), std::move(*preview), this);
  if (dialog.exec() == QDialog::Accepted) openTrace(path, dialog.options());
}

void MainWindow::openTrace(const QString& path, const TraceOptions& options) {
  docks_["traceDock"]->show();
  docks_["traceDock"]->raise();
  actions_->close_trace->setEnabled(true);
  const auto& timeline = workspace_.timeline();
  tracer_.open(path, options, timeline ? timeline->outcome() : nullptr);
  trace_->setBusy(true);
}

void MainWindow::closeTrace() {
  tracer_.close();
  actions_->close_trace->setEnabled(false);
  takeTrace(nullptr);
}

/// The plan is another one.
void MainWindow::followTrace() {
  if (const auto& timeline = workspace_.timeline()) tracer_.compareWith(timeline->outcome());
}

void MainWindow::takeTrace(const std::shared_ptr<const ui::MeasuredTrace>& trace) {
  for (ui::PlanView* view : plan_views_) view->showTrace(trace);
}

/// A table with a time and positions: polylines have none, and programs are no tables.
bool MainWindow::isTrace(const QString& path) const {
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix != "csv" && suffix != "tsv" && suffix != "txt" && suffix != "dat" && suffix != "log") return false;
  const auto preview = preview_trace(path.toStdString());
  if (!preview) return false;
  const auto has = [&](auto... roles) {
    return std::any_of(preview->columns.begin(), preview->columns.end(),
                       [&](const TraceColumn& c) { return ((c.role == roles) || ...); });
  };
  return has(TraceRole::time, TraceRole::sample) && has(TraceRole::actual, TraceRole::position, TraceRole::commanded);
}

}  // namespace toolpace::studio
