#pragma once
/// One worker thread whose results arrive on the thread of its owner.

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <stop_token>

#include "toolpace/base/monitor.h"

namespace toolpace::ui {

/// Runs one task at a time. Finished work is delivered in the event loop, so nothing arrives after destruction.
class Background : public QObject {
  Q_OBJECT

 public:
  /// Runs on the worker; returns what is to be done with the result on the owner's thread.
  using Delivery = std::function<void()>;
  using Task = std::function<Delivery(const Monitor&)>;

  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  bool isBusy() const { return running_; }
  /// Precondition: not busy.
  void start(Task task);
  /// Asks the running task to stop; its delivery still arrives.
  void cancel();

 signals:
  void progressed(double fraction);
  void finished();  ///< after the delivery

 private:
  QThreadPool pool_;
  std::stop_source stop_;
  bool running_ = false;
};

}  // namespace toolpace::ui
