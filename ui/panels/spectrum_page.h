#pragma once
/// Amplitudes of the commanded acceleration over frequency, and time at each speed by what limits it.

#include <QComboBox>
#include <QLabel>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "drawing/plan_view.h"
#include "jobs/analysis_service.h"

class QCPBars;
class QCPGraph;
class QCPItemStraightLine;
class QCustomPlot;

namespace toolpace::ui {

class LineKey;

/// Looks at the plan while it is visible.
class SpectrumPage : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit SpectrumPage(QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setTheme(const Theme& theme) override;
  void setUnits(Units unit) override;
  void setVisibleTime(double begin, double end);  ///< [s] of the plots
  void setRotaryAxes(const std::array<bool, 3>& shown);

  const std::shared_ptr<const MotionAnalysis>& analysis() const { return analysis_; }
  bool isBusy() const { return service_.isRunning() || delay_.isActive(); }

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void buildPlots();
  void ask();
  void draw();
  void drawSpectrum();
  void drawHistogram();
  void markModes();
  void showVerdict();
  void retranslate();
  void dress();
  std::optional<std::size_t> axis() const;
  DisplayUnit amplitudeUnit() const;

  AnalysisService service_;
  QTimer delay_;
  Planned plan_;
  std::shared_ptr<const MotionAnalysis> analysis_;
  QComboBox *axis_, *range_;
  QLabel* verdict_;
  QCustomPlot *spectrum_, *histogram_;
  QCPGraph* curve_ = nullptr;
  std::vector<QCPItemStraightLine*> modes_;  ///< marks; as many as were ever needed
  std::vector<QCPBars*> bars_;
  LineKey* key_;
  Theme theme_ = light_theme();
  Units unit_;
  double begin_ = 0, end_ = 0;
  std::array<bool, 3> rotary_ = {};
};

}  // namespace toolpace::ui
