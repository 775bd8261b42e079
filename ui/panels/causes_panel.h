#pragma once
/// Where the time goes, by what holds the speed down.

#include <QTableWidget>
#include <QWidget>
#include <memory>

#include "drawing/plan_view.h"
#include "models/timeline.h"
#include "theme/theme.h"

namespace toolpace::ui {

class CausesPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit CausesPanel(QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setTheme(const Theme& theme) override;

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void showCauses();
  void retranslate();

  QTableWidget* causes_;
  std::shared_ptr<const Timeline> timeline_;
  Theme theme_ = light_theme();
  bool stale_ = false;  // the causes are not yet those of the timeline
};

}  // namespace toolpace::ui
