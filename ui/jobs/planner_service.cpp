#include "jobs/planner_service.h"

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
    emit busyChanged(true);
    start(std::move(job), latest_);
  }
  return latest_;
}

void PlannerService::cancel() {
  pending_ = nullptr;
  worker_.cancel();
}

void PlannerService::start(std::shared_ptr<const Job> job, quint64 generation) {
  worker_.start([this, job = std::move(job), generation](const Monitor& monitor) -> Background::Delivery {
    auto outcome = run(job, monitor);
    if (!outcome) {
      return [this, error = outcome.error(), generation] { emit failed(error, generation); };
    }
    const auto shared = std::make_shared<const Outcome>(std::move(*outcome));
    Planned plan{std::make_shared<const Timeline>(shared), make_contour_scene(shared), make_profile_series(shared),
                 nullptr};
    return [this, plan = std::move(plan), generation] { emit planned(plan, generation); };
  });
}

}  // namespace toolpace::ui
