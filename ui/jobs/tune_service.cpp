#include "jobs/tune_service.h"

namespace toolpace::ui {

TuneService::TuneService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &TuneService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!next_) return emit finished();
    worker_.start(std::exchange(next_, nullptr));
  });
}

void TuneService::sweep(std::shared_ptr<const Job> job) {
  const quint64 number = ++latest_;
  submit([this, job = std::move(job), number](const Monitor& monitor) {
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
  submit([this, job = std::move(job), cycle_time, number](const Monitor& monitor) {
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

void TuneService::cancel() {
  ++latest_;
  next_ = nullptr;
  worker_.cancel();
}

void TuneService::submit(Background::Task task) {
  if (worker_.isBusy()) {
    next_ = std::move(task);
    worker_.cancel();
  } else {
    worker_.start(std::move(task));
  }
}

Background::Delivery TuneService::ifLatest(quint64 number, Background::Delivery delivery) {
  return [this, number, delivery = std::move(delivery)] {
    if (number == latest_) delivery();
  };
}

}  // namespace toolpace::ui
