#pragma once
/// Moves the cursor along in real or scaled time.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace toolpace::ui {

class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(QObject* parent = nullptr);

  bool isPlaying() const { return timer_.isActive(); }
  double rate() const { return rate_; }

  void setRate(double rate);  ///< 1 = real time; > 0
  /// Plays from `time` to `end`; from the beginning where `time` is the end.
  void play(double time, double end);
  void pause();

 signals:
  void advanced(double time);
  void playingChanged(bool playing);

 private:
  void tick();

  QTimer timer_;
  QElapsedTimer clock_;
  double rate_ = 1.0, from_ = 0.0, end_ = 0.0;
};

}  // namespace toolpace::ui
