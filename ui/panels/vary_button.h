#pragma once
/// Which settings a search may change.

#include <QAction>
#include <QToolButton>
#include <array>
#include <vector>

#include "toolpace/tune/tuning_space.h"

namespace toolpace::ui {

/// A button with a list of settings to tick; all of them at first. The last one that is ticked stays.
class VaryButton : public QToolButton {
  Q_OBJECT

 public:
  explicit VaryButton(QWidget* parent = nullptr);

  std::vector<Knob> chosen() const;
  void retranslate();

 private:
  void keepOne(QAction* action);
  void showCount();

  std::array<QAction*, kKnobCount> actions_;
};

}  // namespace toolpace::ui
