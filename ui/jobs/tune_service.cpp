#include "jobs/tune_service.h"

namespace toolpace::ui {

template <class T, class Argument>
Background::Delivery TuneService::answer(quint64 number, Result<T> result, void (TuneService::*signal)(Argument)) {
  return [this, number, result = std::move(result), signal] {
    if (number != latest_) return;
    if (result) {
      emit(this->*signal)(*result);
    } else {
      emit failed(result.error());
    }
  };
}

TuneService::TuneService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &TuneService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!next_) return emit finished();
    std::exchange(next_, nullptr)();
  });
}

void TuneService::sweep(std::shared_ptr<const Job> job) {
  const quint64 number = ++latest_;
  submit(number, [this, job = std::move(job), number](const Monitor& monitor) {
    auto result = sweep_lookahead(*job, monitor);
    return answer(number, std::move(result), &TuneService::swept);
  });
}

void TuneService::search(std::shared_ptr<const Job> job, const TuneOptions& options) {
  const quint64 number = ++latest_;
  submit(number, [this, job = std::move(job), options, number](const Monitor& monitor) {
    auto result = tune(job, options, monitor);
    return answer(number, std::move(result), &TuneService::tuned);
  });
}

void TuneService::trySingleChanges(std::shared_ptr<const Job> job) {
  const quint64 number = ++latest_;
  constexpr double kTenPerCent = 1.1;
  submit(number, [this, job = std::move(job), number](const Monitor& monitor) {
    auto result = try_single_changes(job, kTenPerCent, monitor);
    return answer(number, std::move(result), &TuneService::changesTried);
  });
}

void TuneService::advise(std::shared_ptr<const Job> job, std::optional<double> limit) {
  const quint64 number = ++latest_;
  submit(number, [this, job = std::move(job), limit, number](const Monitor& monitor) {
    auto result = advise_on_vibration(job, limit, monitor);
    return answer(number, std::move(result), &TuneService::advised);
  });
}

void TuneService::trySettings(std::shared_ptr<const Controlled> run) {
  const quint64 number = ++latest_;
  submit(number, [this, run = std::move(run), number](const Monitor& monitor) {
    auto result = what_if(*run->reading, *run->text, run->asked->settings, run->supply, monitor);
    return answer(number, std::move(result), &TuneService::settingsTried);
  });
}

void TuneService::searchSettings(std::shared_ptr<const Controlled> run, const SettingsSearch& search) {
  const quint64 number = ++latest_;
  SettingsSearch asked = search;
  asked.predict = run->supply;
  submit(number, [this, run = std::move(run), asked = std::move(asked), number](const Monitor& monitor) {
    auto result = tune_settings(*run->reading, *run->text, run->asked->settings, asked, monitor);
    return answer(number, std::move(result), &TuneService::settingsTuned);
  });
}

void TuneService::planSetpoints(std::shared_ptr<const Controlled> run) {
  const quint64 number = ++latest_;
  submit(number, [this, run = std::move(run), number](const Monitor& monitor) {
    const bool refined = run->prediction.cycle_time < kLongestRefined;
    auto result = cycle_time_as_setpoints(run->reading, run->asked->settings, kToleranceOfSetpoints, refined, monitor);
    return answer(number, std::move(result), &TuneService::setpointsPlanned);
  });
}

void TuneService::cancel() {
  ++latest_;
  next_ = nullptr;
  worker_.cancel();
}

void TuneService::submit(quint64 number, Background::Task task) {
  const auto start = [this, number, task = std::move(task)] {
    worker_.start(task, [this, number](const Error& error) {
      if (number == latest_) emit failed(error);
    });
  };
  if (!worker_.isBusy()) return start();
  next_ = start;
  worker_.cancel();
}

}  // namespace toolpace::ui
