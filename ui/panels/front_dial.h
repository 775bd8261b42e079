#pragma once
/// Rough – finish – fine: a slider along a front, with the numbers of where it stands.

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>
#include <memory>
#include <optional>

#include "models/units.h"
#include "toolpace/tune/tune.h"

namespace toolpace::ui {

class FrontDial : public QWidget {
  Q_OBJECT

 public:
  explicit FrontDial(QWidget* parent = nullptr);

  /// Null or stale: there is nothing to turn.
  void setTuning(std::shared_ptr<const toolpace::TuneResult> tuning, bool stale);
  /// The point whose settings are in use; nothing = none of them.
  void setUsed(std::optional<std::size_t> index);
  void setUnits(Units units);
  void retranslate();

 signals:
  void chosen(std::size_t index);  ///< of the front
  void gestureStarted();
  void gestureFinished();

 private:
  void showNumbers();

  QSlider* slider_;
  QLabel *rough_, *finish_, *fine_, *numbers_;
  QPushButton *best_, *knee_;
  std::shared_ptr<const toolpace::TuneResult> tuning_;
  std::optional<std::size_t> used_;
  Units units_;
};

/// "3.214 s · 8.2 µm", with the vibration where it is known.
QString objectives_text(const Objectives& o, Units units);

}  // namespace toolpace::ui
