#pragma once
/// Sweeps the look-ahead, and finds what raising each limit saves, in a worker.

#include <QObject>
#include <functional>
#include <memory>

#include "jobs/background.h"
#include "toolpace/tune/savings.h"
#include "toolpace/tune/sweep.h"

namespace toolpace::ui {

/// A newer request replaces an older one, whose result never arrives.
class TuneService : public QObject {
  Q_OBJECT

 public:
  explicit TuneService(QObject* parent = nullptr);

  void sweep(std::shared_ptr<const Job> job);
  void findSavings(std::shared_ptr<const Job> job, double cycle_time);
  void cancel();
  bool isRunning() const { return worker_.isBusy() || next_; }

 signals:
  void swept(const toolpace::LookaheadSweep& sweep);
  void savingsFound(const std::vector<toolpace::Saving>& savings);
  void failed(const toolpace::Error& error);
  void progressed(double fraction);
  void finished();

 private:
  void submit(quint64 number, Background::Task task);
  /// Wraps a delivery so that it is dropped when the request is no longer the latest.
  Background::Delivery ifLatest(quint64 number, Background::Delivery delivery);

  Background worker_;
  std::function<void()> next_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
