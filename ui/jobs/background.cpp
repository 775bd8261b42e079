#include "jobs/background.h"

#include <memory>
#include <utility>

#include "toolpace/base/exception_error.h"

namespace toolpace::ui {
namespace {

constexpr double kProgressStep = 0.01;  // do not flood the event loop

}  // namespace

Background::Background(QObject* parent) : QObject(parent) {}

Background::~Background() {
  stop_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void Background::start(Task task, Failure failure) {
  Q_ASSERT(!running_);
  running_ = true;
  stop_ = std::stop_source();
  Monitor monitor;
  monitor.stop = stop_.get_token();
  monitor.progress = [this, last = std::make_shared<double>(0.0)](double fraction) {  // one for all copies
    if (fraction < *last + kProgressStep) return;
    *last = fraction;
    mailbox_.post([this, fraction] { emit progressed(fraction); });
  };
  const auto post = [this, failure](Delivery delivery) {
    mailbox_.post([this, delivery = std::move(delivery), failure] { conclude(delivery, failure); });
  };
  const auto caught = [failure] { return [failure, error = caught_error()] { failure(error); }; };
  try {
    thread_ = std::thread([work = std::move(task), monitor = std::move(monitor), post, caught]() mutable {
      Delivery delivery;
      try {
        delivery = work(monitor);
      } catch (...) {
        delivery = caught();
      }
      work = nullptr;  // what it alone held is freed here, not while the owner waits for the thread's end
      post(std::move(delivery));
    });
  } catch (...) {  // the system has no thread left
    post(caught());
  }
}

void Background::conclude(const Delivery& delivery, const Failure& failure) {
  if (thread_.joinable()) thread_.join();
  try {
    if (delivery) delivery();  // still busy: what it submits waits for finished()
  } catch (...) {
    failure(caught_error());
  }
  running_ = false;
  emit finished();
}

void Background::cancel() { stop_.request_stop(); }

}  // namespace toolpace::ui
