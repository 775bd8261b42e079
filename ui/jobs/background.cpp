#include "jobs/background.h"

#include <QMetaObject>
#include <memory>

#include "toolpace/base/exception_error.h"

namespace toolpace::ui {
namespace {

constexpr double kProgressStep = 0.01;  // do not flood the event loop

}  // namespace

Background::Background(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

Background::~Background() {
  stop_.request_stop();
  pool_.waitForDone();
}

void Background::start(Task task, Failure failure) {
  Q_ASSERT(!running_);
  running_ = true;
  stop_ = std::stop_source();
  Monitor monitor;
  monitor.stop = stop_.get_token();
  monitor.progress = [this, last = std::make_shared<double>(0.0)](double fraction) {
    if (fraction < *last + kProgressStep) return;
    *last = fraction;
    QMetaObject::invokeMethod(
        this, [this, fraction] { emit progressed(fraction); }, Qt::QueuedConnection);
  };
  pool_.start([this, work = std::move(task), fail = std::move(failure), monitor = std::move(monitor)] {
    Delivery delivery;
    try {
      delivery = work(monitor);
    } catch (...) {
      delivery = [fail, error = caught_error()] { fail(error); };
    }
    QMetaObject::invokeMethod(
        this,
        [this, hand_over = std::move(delivery), fail] {
          try {
            if (hand_over) hand_over();  // still busy: what it submits waits for finished()
          } catch (...) {
            fail(caught_error());
          }
          running_ = false;
          emit finished();
        },
        Qt::QueuedConnection);
  });
}

void Background::cancel() { stop_.request_stop(); }

}  // namespace toolpace::ui
