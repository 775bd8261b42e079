/// The controller that the program of a workspace runs on.

#include "jobs/workspace.h"

namespace toolpace::ui {
namespace {

/// Another file, or another controller: nothing of what was found before is of it.
bool is_another(const SharedControllerText& a, const SharedControllerText& b) {
  return !a || !b || a->path != b->path || a->settings.controller != b->settings.controller;
}

}  // namespace

void Workspace::connectController() {
  connect(&controller_model_, &ControllerModel::changed, this, &Workspace::takeSettings);
  connect(&controller_, &ControllerService::driven, this, &Workspace::takeDriven);
  connect(&controller_, &ControllerService::failed, this, &Workspace::takeUndriven);
  connect(&controller_, &ControllerService::progressed, this, &Workspace::progressed);
  connect(&controller_, &ControllerService::busyChanged, this, [this] { emit busyChanged(isBusy()); });
  connect(&setpoints_, &TuneService::setpointsPlanned, this, [this](double cycle_time) {
    controller_view_.as_setpoints = cycle_time;
    emit controllerChanged();
  });
}

void Workspace::takeSettings() {
  const SharedControllerText& text = controller_model_.text();
  const bool another = is_another(controller_view_.chosen, text);
  if (another) {
    if (text) pinned_ = {};  // what the controller does is to be seen
    forgetController();
  }
  controller_view_.chosen = text;
  runOnController();
  emit controllerChanged();
  if (!another) return;
  emit pinnedChanged();
  if (document_) showProblems();
}

void Workspace::forgetController() {
  setpoints_.cancel();
  controller_.cancel();
  controller_view_ = {controller_view_.chosen, controller_view_.supply, nullptr};
  oldest_run_ = latest_run_ + 1;
}

void Workspace::runOnController() {
  if (!document_ || !controller_view_.chosen) return;
  setpoints_.cancel();
  controller_view_.is_stale = true;
  latest_run_ = controller_.submit(document_, controller_view_.chosen, readOptions(), controller_view_.supply);
  emit controllerChanged();
}

void Workspace::setSupply(const PredictOptions& supply) {
  if (supply.baud == controller_view_.supply.baud && supply.block_time == controller_view_.supply.block_time) return;
  controller_view_.supply = supply;
  runOnController();
  emit controllerChanged();
}

void Workspace::takeDriven(const std::shared_ptr<const Controlled>& found, quint64 generation) {
  if (generation < oldest_run_ || !controller_view_.chosen) return;
  controller_view_.found = found;
  controller_view_.failure.reset();
  controller_view_.as_setpoints.reset();
  if (controller_.isLatest(generation)) {
    controller_view_.is_stale = false;
    setpoints_.planSetpoints(found);
  }
  emit controllerChanged();
  emit pinnedChanged();
  showProblems();
  makeAxes();
}

void Workspace::takeUndriven(const Error& error, quint64 generation) {
  if (!controller_.isLatest(generation) || generation < oldest_run_ || error.kind == ErrorKind::cancelled) return;
  controller_view_ = {controller_view_.chosen, controller_view_.supply, nullptr, {}, error};
  emit controllerChanged();
  emit pinnedChanged();
  showProblems();
}

Diagnostics Workspace::controllerProblems() const {
  if (const auto& error = controller_view_.failure) {
    return {{Severity::error, error->code, error->message, error->remedy, error->where, {}}};
  }
  return controller_view_.found ? controller_view_.found->problems : Diagnostics{};
}

}  // namespace toolpace::ui
