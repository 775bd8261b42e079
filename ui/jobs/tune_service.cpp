#include "jobs/tune_service.h"

namespace toolpace::ui {

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
    return ifLatest(number, [this, result = std::move(result)] {
      if (result) {
        emit swept(*result);
      } else {
        emit failed(result.error());
      }
    });
  });
}

void TuneService::findSavings(std::shared_ptr<const Job> job, double cycle_time) {
  const quint64 number = ++latest_;
  constexpr double kRaise = 1.1;
  submit(number, [this, job = std::move(job), cycle_time, number](const Monitor& monitor) {
    auto result = find_savings(*job, cycle_time, kRaise, monitor);
    return ifLatest(number, [this, result = std::move(result)] {
      if (result) {
        emit savingsFound(*result);
      } else {
        emit failed(result.error());
      }
    });
  });
}

void TuneService::trySettings(std::shared_ptr<const Controlled> run) {
  const quint64 number = ++latest_;
  submit(number, [this, run = std::move(run), number](const Monitor& monitor) {
    auto result = what_if(*run->reading, *run->text, run->asked->settings, {}, monitor);
    return ifLatest(number, [this, result = std::move(result)] {
      if (result) {
        emit settingsTried(*result);
      } else {
        emit failed(result.error());
      }
    });
  });
}

void TuneService::planSetpoints(std::shared_ptr<const Controlled> run) {
  const quint64 number = ++latest_;
  submit(number, [this, run = std::move(run), number](const Monitor& monitor) {
    const bool refined = run->prediction.cycle_time < kLongestRefined;
    auto result = cycle_time_as_setpoints(run->reading, run->asked->settings, kToleranceOfSetpoints, refined, monitor);
    return ifLatest(number, [this, result = std::move(result)] {
      if (result) {
        emit setpointsPlanned(*result);
      } else {
        emit failed(result.error());
      }
    });
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

Background::Delivery TuneService::ifLatest(quint64 number, Background::Delivery delivery) {
  return [this, number, delivery = std::move(delivery)] {
    if (number == latest_) delivery();
  };
}

}  // namespace toolpace::ui
