#include "jobs/playback.h"

#include <algorithm>

namespace toolpace::ui {
namespace {

constexpr int kFrameMs = 16;
constexpr double kSecondsPerMs = 1e-3;

}  // namespace

Playback::Playback(QObject* parent) : QObject(parent) {
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Playback::tick);
}

void Playback::setRate(double rate) {
  if (isPlaying()) {
    from_ += static_cast<double>(clock_.restart()) * kSecondsPerMs * rate_;
  }
  rate_ = rate;
}

void Playback::play(double time, double end) {
  if (end <= 0) return;
  from_ = time >= end ? 0.0 : time;
  end_ = end;
  clock_.start();
  timer_.start();
  emit playingChanged(true);
}

void Playback::pause() {
  if (!isPlaying()) return;
  timer_.stop();
  emit playingChanged(false);
}

void Playback::tick() {
  const double time = from_ + static_cast<double>(clock_.elapsed()) * kSecondsPerMs * rate_;
  emit advanced(std::min(time, end_));
  if (time >= end_) pause();
}

}  // namespace toolpace::ui
