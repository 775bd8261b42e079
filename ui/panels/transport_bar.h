#pragma once
/// The bottom line: playback, read-out at the cursor, progress and cancel.

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <optional>

#include "drawing/plan_view.h"
#include "models/timeline.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

class TransportBar : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit TransportBar(QWidget* parent = nullptr);

  void showInstant(const std::optional<Instant>& instant) override;
  void setBlockName(const QString& name);                 ///< of the instant that is shown next
  void setRotaryAxes(const std::array<bool, 3>& turned);  ///< which of A, B, C are read out
  void setPlaying(bool playing);
  void setBusy(bool busy);
  void setTask(const QString& text);  ///< what it is busy with
  void setProgress(double fraction);
  void setMessage(const QString& text);
  void setUnits(Units unit) override;
  void setTheme(const Theme& theme) override;

 signals:
  void firstRequested();
  void previousRequested();
  void playRequested();
  void nextRequested();
  void lastRequested();
  void rateChanged(double rate);
  void cancelRequested();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum Number : std::size_t { kTime, kPlace, kSpeed, kAcceleration, kNumbers };

  QToolButton* addButton(const char* name, const char* icon_name, void (TransportBar::*signal)());
  void retranslate();
  void fit();
  void refresh();
  void showBusy(bool busy);
  QString steady(Number number, double value, int decimals);
  void showCause(Cause cause);
  void forgetCause();

  QToolButton *first_, *previous_, *play_, *next_, *last_, *cancel_;
  QComboBox* rate_;
  QLabel *time_, *place_, *motion_, *message_, *busy_;
  QProgressBar* progress_;
  QTimer patience_;  // what is done before it ends needs no bar
  std::optional<Instant> instant_;
  QString block_name_;
  Units unit_;
  // Characters that each number has taken so far, so that they do not jump while it plays.
  std::array<int, kNumbers> widths_ = {};
  Theme theme_ = light_theme();
  std::array<bool, 3> turned_ = {};
  bool playing_ = false;
};

}  // namespace toolpace::ui
