#pragma once
/// One worker thread whose results arrive on the thread of its owner.

#include <QObject>
#include <functional>
#include <stop_token>
#include <thread>

#include "jobs/mailbox.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"

namespace toolpace::ui {

/// Runs one task at a time. Finished work is delivered in the event loop, so nothing arrives after destruction.
class Background : public QObject {
  Q_OBJECT

 public:
  /// Runs on the worker; returns what is to be done with the result on the owner's thread.
  using Delivery = std::function<void()>;
  using Task = std::function<Delivery(const Monitor&)>;
  /// What is to be done, on the owner's thread, when a task or its delivery threw: "out-of-memory" or "internal".
  using Failure = std::function<void(const Error&)>;

  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  bool isBusy() const { return running_; }
  /// Precondition: not busy. Exactly one of the task's delivery and `failure` is done to its end.
  void start(Task task, Failure failure);
  /// Asks the running task to stop; its delivery still arrives.
  void cancel();

 signals:
  void progressed(double fraction);
  void finished();  ///< after the delivery or the failure

 private:
  void conclude(const Delivery& delivery, const Failure& failure);

  Mailbox mailbox_;
  std::thread thread_;  ///< of the running task alone
  std::stop_source stop_;
  bool running_ = false;
};

}  // namespace toolpace::ui
