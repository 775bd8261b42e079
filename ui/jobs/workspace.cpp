#include "jobs/workspace.h"

#include <algorithm>
#include <utility>

#include "toolpace/pipeline/strategy.h"

namespace toolpace::ui {
namespace {

Diagnostic as_diagnostic(const Error& error) {
  return {Severity::error, error.code, error.message, error.remedy, error.where, {}};
}

}  // namespace

Workspace::Workspace(QObject* parent) : QObject(parent) {
  connectProgram();
  connect(&tuning_, &TuningModel::changed, this, &Workspace::followMachine);
  connect(&tuning_, &TuningModel::changed, this, &Workspace::replan);
  connect(&planner_, &PlannerService::planned, this, &Workspace::takePlan);
  connect(&planner_, &PlannerService::failed, this, &Workspace::takeFailure);
  connect(&planner_, &PlannerService::progressed, this, &Workspace::progressed);
  connect(&proof_service_, &ProofService::proven, this, &Workspace::takeProof);
  connect(&proof_service_, &ProofService::failed, this, &Workspace::addProblem);
  connect(&proof_service_, &ProofService::stateChanged, this, &Workspace::proofStateChanged);
  connect(&refiner_, &Refiner::refined, this, &Workspace::takeRefined);
  connect(&refiner_, &Refiner::failed, this, [this](const Error& error) { collectProblems({as_diagnostic(error)}); });
  connect(&refiner_, &Refiner::progressed, this, &Workspace::progressed);
  connect(&refiner_, &Refiner::stateChanged, this, [this](Refiner::State state) {
    emit refinementChanged(state);
    emit busyChanged(isBusy());
    if (state == Refiner::State::given_up && plan_) proof_service_.request(plan_.scene);
  });
  connectController();
  connect(&axis_worker_, &Background::finished, this, &Workspace::makeAxes);
  connect(&playback_, &Playback::advanced, this, &Workspace::setCursorTime);
  connect(&planner_, &PlannerService::busyChanged, this, [this] { emit busyChanged(isBusy()); });
}

std::shared_ptr<const Job> Workspace::job() const {
  if (!document_) return nullptr;
  auto job = std::make_shared<Job>();
  job->program_name = document_->name.toStdString();
  job->program = document_->reading;
  job->machine = tuning_.value().machine;
  job->options = tuning_.value().options;
  return job;
}

void Workspace::cancel() {
  reader_.cancel();
  giveUpOpening();
  planner_.cancel();
  controller_.cancel();
  setpoints_.cancel();
  refiner_.giveUp();
}

void Workspace::checkNow() {
  if (plan_ && !plan_.proof) proof_service_.requestNow(plan_.scene);
}

void Workspace::stopChecking() { proof_service_.stop(); }

void Workspace::replan() {
  const auto next = job();
  if (!next) return;
  setStale(true);
  refiner_.drop();
  proof_service_.request(nullptr);
  planner_.submit(takes_long(*next) ? quick_version(*next) : next);
}

void Workspace::takePlan(const Planned& plan, quint64 generation) {
  if (!document_ || plan.timeline->outcome()->job->program != document_->reading) return;  // another program was opened
  if (planner_.isLatest(generation)) setStale(read_state_ != program_.state());
  show(plan);
  if (stale_) return;
  const auto asked = job();
  if (takes_long(*asked)) return refiner_.request(asked);
  proof_service_.request(plan_.scene);
}

void Workspace::takeRefined(const Planned& plan) {
  if (!document_ || plan.timeline->outcome()->job->program != document_->reading) return;
  show(plan);
  proof_service_.request(plan_.scene);
}

void Workspace::show(const Planned& plan) {
  plan_ = plan;
  axes_failed_ = false;
  collectProblems(plan_.timeline->outcome()->warnings);
  emit planChanged();
  makeAxes();
  setCursorTime(cursor_);
}

void Workspace::setShownAxes(const ShownAxes& axes) {
  shown_axes_ = axes;
  axes_failed_ = false;
  planner_.setShownAxes(axes);
  refiner_.setShownAxes(axes);
  makeAxes();
}

void Workspace::makeAxes() {
  if (axes_failed_ || axis_worker_.isBusy()) return;
  const auto lacks = [this](const Planned& plan) { return plan && !has_axes(*plan.series, shown_axes_); };
  if (!lacks(plan_) && !lacks(pinned())) return;
  const auto make = [this, series = lacks(plan_) ? plan_.series : pinned().series, axes = shown_axes_](const Monitor&) {
    make_axes(*series, axes);
    return [this] { emit axesReady(); };
  };
  axis_worker_.start(make, [this](const Error& error) {
    axes_failed_ = true;
    addProblem(error);
  });
}

void Workspace::takeProof(std::shared_ptr<const Proof> proof) {
  if (pinned_ && proof->outcome == pinned_.timeline->outcome()) {
    pinned_.proof = proof;
    emit pinnedChanged();
  }
  if (!plan_ || proof->outcome != plan_.timeline->outcome()) return;
  plan_.proof = std::move(proof);
  Diagnostics problems = plan_.timeline->outcome()->warnings;
  const Diagnostics broken = problems_of(plan_.proof->report);
  problems.insert(problems.end(), broken.begin(), broken.end());
  collectProblems(problems);
  emit proofChanged();
}

void Workspace::takeFailure(const Error& error, quint64 generation) {
  if (!planner_.isLatest(generation) || error.kind == ErrorKind::cancelled) return;
  collectProblems({as_diagnostic(error)});
}

void Workspace::collectProblems(const Diagnostics& of_plan) {
  plan_problems_ = of_plan;
  showProblems();
}

void Workspace::addProblem(const Error& error) {
  plan_problems_.push_back(as_diagnostic(error));
  showProblems();
}

void Workspace::showProblems() {
  problems_ = document_->reading->diagnostics;
  problems_.insert(problems_.end(), plan_problems_.begin(), plan_problems_.end());
  const Diagnostics of_controller = controllerProblems();
  problems_.insert(problems_.end(), of_controller.begin(), of_controller.end());
  emit problemsChanged();
}

void Workspace::setStale(bool stale) {
  if (stale_ == stale) return;
  stale_ = stale;
  emit staleChanged(stale);
}

void Workspace::pin() {
  if (!plan_) return;
  pinned_ = plan_;
  emit pinnedChanged();
}

const Planned& Workspace::pinned() const {
  return pinned_ || !controller_view_.found ? pinned_ : controller_view_.found->motion;
}

void Workspace::unpin() {
  if (!pinned_) return controller_model_.replace(tr("Runs on Toolpace's plan"), nullptr);
  pinned_ = {};
  emit pinnedChanged();
}

void Workspace::swap() {
  if (!pinned() || !plan_) return;
  const Planned other = pinned();
  pinned_ = std::exchange(plan_, other);
  const auto job = plan_.timeline->outcome()->job;  // whoever is told may show another plan
  emit pinnedChanged();
  emit planChanged();
  makeAxes();
  Setup setup = tuning_.value();
  setup.machine = job->machine;
  setup.options = job->options;
  tuning_.replace(tr("Swap A and B"), setup);
}

void Workspace::setCursorTime(double time) {
  const double end = plan_ ? plan_.timeline->duration() : 0.0;
  cursor_ = std::clamp(time, 0.0, std::max(end, 0.0));
  emit cursorChanged(cursor_);
}

void Workspace::setCursorLine(std::uint32_t line) {
  if (!plan_) return;
  if (const auto time = plan_.timeline->time_of_line(line)) setCursorTime(*time);
}

void Workspace::stepLine(int direction) {
  if (!plan_) return;
  playback_.pause();
  setCursorTime(direction > 0 ? plan_.timeline->next_line(cursor_) : plan_.timeline->previous_line(cursor_));
}

void Workspace::togglePlay() {
  if (playback_.isPlaying()) {
    playback_.pause();
  } else if (plan_) {
    playback_.play(cursor_, plan_.timeline->duration());
  }
}

}  // namespace toolpace::ui
