#include "jobs/planner_service.h"

#include "toolpace/pipeline/replan.h"

namespace toolpace::ui {

PlannerService::PlannerService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &PlannerService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!pending_) return emit busyChanged(false);
    start(std::exchange(pending_, nullptr), latest_);
  });
}

quint64 PlannerService::submit(std::shared_ptr<const Job> job) {
  ++latest_;
  if (worker_.isBusy()) {
    pending_ = std::move(job);
  } else {
    start(std::move(job), latest_);
    emit busyChanged(true);
  }
  return latest_;
}

void PlannerService::cancel() {
  pending_ = nullptr;
  worker_.cancel();
}

void PlannerService::start(std::shared_ptr<const Job> job, quint64 generation) {
  if (last_.outcome && last_.outcome->job->program != job->program) last_ = {};
  const auto work = [this, job = std::move(job), generation, before = last_, by = shown_,
                     axes = axes_](const Monitor& monitor) -> Background::Delivery {
    auto outcome = before.outcome ? replan(job, *before.outcome, monitor) : run(job, monitor);
    if (!outcome) {
      return [this, error = outcome.error(), generation] { emit failed(error, generation); };
    }
    // What is cancelled while it is made ready to be drawn is not shown.
    const auto given_up = [this, generation]() -> Background::Delivery {
      return [this, generation] { emit failed(cancelled_error(), generation); };
    };
    const auto shared = std::make_shared<const Outcome>(std::move(*outcome));
    Planned plan;
    plan.timeline = std::make_shared<const Timeline>(shared);
    if (monitor.is_cancelled()) return given_up();
    plan.scene = make_contour_scene(shared, nullptr, before.geometry);
    if (monitor.is_cancelled()) return given_up();
    plan.series = make_profile_series(shared);
    if (monitor.is_cancelled()) return given_up();
    // What will be drawn first is made here rather than when it is drawn.
    if (plan.scene->can_colour_by(by)) (void)plan.scene->colours->shades(by);
    make_axes(*plan.series, axes);
    if (monitor.is_cancelled()) return given_up();
    return [this, plan = std::move(plan), generation] {
      last_ = {plan.timeline->outcome(), plan.scene->geometry};
      emit planned(plan, generation);
    };
  };
  worker_.start(work, [this, generation](const Error& error) { emit failed(error, generation); });
}

}  // namespace toolpace::ui
