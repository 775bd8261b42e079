#pragma once
/// Says that what is shown is an example, with three things to try.

#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>
#include <array>

#include "theme/theme.h"

namespace toolpace::ui {

class WelcomeBar : public QWidget {
  Q_OBJECT

 public:
  enum class Try { jerk, tolerance, open };

  explicit WelcomeBar(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);

 signals:
  void tried(toolpace::ui::WelcomeBar::Try what);
  void dismissed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  QLabel* text_;
  std::array<QPushButton*, 3> buttons_ = {};
  QToolButton* close_;
};

}  // namespace toolpace::ui
