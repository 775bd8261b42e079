#include "jobs/refiner.h"

namespace toolpace::ui {
namespace {

constexpr int kRefineDelayMs = 150;

}  // namespace

Refiner::Refiner(QObject* parent) : QObject(parent) {
  delay_.setSingleShot(true);
  delay_.setInterval(kRefineDelayMs);
  connect(&delay_, &QTimer::timeout, this, [this] {
    if (wanted_) planner_.submit(wanted_);
  });
  connect(&planner_, &PlannerService::progressed, this, [this](double fraction) {
    if (state_ == State::running) emit progressed(fraction);
  });
  connect(&planner_, &PlannerService::planned, this, [this](const Planned& plan) {
    if (!wanted_ || plan.timeline->outcome()->job != wanted_) return;  // of a job before the last edit
    wanted_ = nullptr;
    setState(State::idle);
    emit refined(plan);
  });
  connect(&planner_, &PlannerService::failed, this, [this](const Error& error, quint64 generation) {
    if (!wanted_ || !planner_.isLatest(generation) || error.kind == ErrorKind::cancelled) return;
    giveUp();
    emit failed(error);
  });
}

void Refiner::request(std::shared_ptr<const Job> job) {
  planner_.cancel();
  wanted_ = std::move(job);
  delay_.start();
  setState(State::running);
}

void Refiner::drop() {
  delay_.stop();
  planner_.cancel();
  wanted_ = nullptr;
  setState(State::idle);
}

void Refiner::giveUp() {
  if (state_ != State::running) return;
  delay_.stop();
  planner_.cancel();
  wanted_ = nullptr;
  setState(State::given_up);
}

void Refiner::setState(State state) {
  if (state == state_) return;
  state_ = state;
  emit stateChanged(state);
}

}  // namespace toolpace::ui
