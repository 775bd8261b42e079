#include "jobs/background.h"

#include <QMetaObject>
#include <memory>

namespace toolpace::ui {
namespace {

constexpr double kProgressStep = 0.01;  // do not flood the event loop

}  // namespace

Background::Background(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

Background::~Background() {
  stop_.request_stop();
  pool_.waitForDone();
}

void Background::start(Task task) {
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
  pool_.start([this, work = std::move(task), monitor = std::move(monitor)] {
    Delivery delivery = work(monitor);
    QMetaObject::invokeMethod(
        this,
        [this, hand_over = std::move(delivery)] {
          if (hand_over) hand_over();  // still busy: what it submits waits for finished()
          running_ = false;
          emit finished();
        },
        Qt::QueuedConnection);
  });
}

void Background::cancel() { stop_.request_stop(); }

}  // namespace toolpace::ui
