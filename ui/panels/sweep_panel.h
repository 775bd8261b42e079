#pragma once
/// Cycle time over look-ahead depth, with the knee marked.

#include <QLabel>
#include <QPushButton>
#include <QVector>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "drawing/plan_view.h"
#include "jobs/tune_service.h"
#include "models/timeline.h"
#include "theme/theme.h"

class QCustomPlot;
class QCPGraph;

namespace toolpace::ui {

class SweepPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit SweepPanel(QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setTheme(const Theme& theme) override;
  void compute();
  bool isComputing() const { return service_.isRunning(); }
  const LookaheadSweep& lastSweep() const { return sweep_; }

 signals:
  void depthRequested(std::optional<std::size_t> depth);  ///< somebody clicked on a point
  void computed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  double positionOf(std::size_t index) const;
  void draw();
  void drawAxes(const QVector<double>& x, const QVector<double>& y);
  void showVerdict();
  void retranslate();
  void pick(double x);

  TuneService service_;
  QCustomPlot* plot_;
  QCPGraph *curve_, *mark_;
  QLabel* verdict_;
  QPushButton* button_;
  std::shared_ptr<const Timeline> timeline_;
  LookaheadSweep sweep_;  // no points before the first one
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
