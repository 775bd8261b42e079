#pragma once
/// The page "Circle": how round the simulated drives make the arc under the cursor.

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "drawing/plan_view.h"
#include "drawing/planned.h"
#include "panels/polar_plot.h"

namespace toolpace::ui {

class CirclePanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit CirclePanel(QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  /// Shows the circle that is cut at this instant, if there is one.
  void showInstant(const std::optional<Instant>& instant) override;
  void setUnits(Units unit) override;
  void setTheme(const Theme& theme) override;
  const Roundness& roundness() const { return *roundness_; }

 signals:
  void cursorTimeRequested(double time);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void look();
  void measure(std::size_t block);
  void step(int direction);
  void showFigures();
  void retranslate();

  QLabel *title_, *figures_;
  QToolButton *previous_, *next_;
  QComboBox* enlargement_;
  PolarPlot* plot_;
  Planned plan_;
  double cursor_ = 0;
  bool stale_ = true;  // the plan is another than the one measured
  std::shared_ptr<const Roundness> roundness_ = std::make_shared<Roundness>();
  Units unit_;
};

}  // namespace toolpace::ui
