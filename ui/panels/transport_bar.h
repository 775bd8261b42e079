#pragma once
/// The bottom line: playback, read-out at the cursor, progress and cancel.

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "models/timeline.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

class TransportBar : public QWidget {
  Q_OBJECT

 public:
  explicit TransportBar(QWidget* parent = nullptr);

  void setInstant(const std::optional<Instant>& instant);
  void setPlaying(bool playing);
  void setBusy(bool busy);
  void setTask(const QString& text);  ///< what it is busy with
  void setProgress(double fraction);
  void setMessage(const QString& text);
  void setLengthUnit(LengthUnit unit);
  void setTheme(const Theme& theme);

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

 private:
  QToolButton* addButton(const char* name, const char* icon_name, void (TransportBar::*signal)());
  void retranslate();
  void showInstant();

  QToolButton *first_, *previous_, *play_, *next_, *last_, *cancel_;
  QComboBox* rate_;
  QLabel *time_, *place_, *motion_, *message_, *busy_;
  QProgressBar* progress_;
  std::optional<Instant> instant_;
  LengthUnit unit_ = LengthUnit::mm;
  Theme theme_ = light_theme();
  bool playing_ = false;
};

}  // namespace toolpace::ui
