#pragma once
/// The page "Tune": the best settings for the program on its machine, found, shown and taken; where it runs on a controller, that
/// one's own settings.

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>

#include "drawing/plan_view.h"
#include "jobs/tune_service.h"
#include "models/tuning_model.h"
#include "panels/front_dial.h"
#include "panels/front_plot.h"
#include "panels/number_field.h"
#include "panels/single_changes_panel.h"
#include "panels/tune_settings_panel.h"
#include "panels/vary_button.h"

namespace toolpace::ui {

/// Settings that are taken become an undo step of the model; one turn of the dial is one step.
class TunePage : public QWidget, public PlanView {
  Q_OBJECT

 public:
  TunePage(TuningModel& model, ControllerModel& controller, QWidget* parent = nullptr);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void showController(const ControllerView& view) override;
  void setTheme(const Theme& theme) override;
  void setUnits(Units units) override;
  void search();  ///< what is shown: this planner's settings, or the controller's
  bool isSearching() const { return service_.isRunning(); }
  SingleChangesPanel& changes() { return *changes_; }
  TuneSettingsPanel& ofController() { return *of_controller_; }
  /// What was found last; null before that.
  const std::shared_ptr<const toolpace::TuneResult>& tuning() const { return tuning_; }
  bool isStale() const { return stale_; }  ///< what was found is of another program, or other settings are in use

 signals:
  void searched();  ///< to its end, or not

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void build();
  void connectParts();
  QWidget* buildHead();
  QWidget* buildRight();
  std::shared_ptr<const Job> job() const;
  void stop();
  bool shakes() const;
  void take(const std::shared_ptr<const Job>& job);
  void look();
  void showChanges();
  void showState();
  void retranslate();

  TuningModel& model_;
  TuneService service_;
  VaryButton* vary_;
  QLabel *limit_label_, *limit_unit_, *vibration_label_, *vibration_unit_, *plans_label_, *verdict_, *changes_title_;
  NumberField *limit_, *vibration_, *plans_;
  QWidget* vibration_part_ = nullptr;  // there where an axis has a mode
  QPushButton* button_;
  FrontPlot* plot_;
  FrontDial* dial_;
  QTableWidget* settings_;
  SingleChangesPanel* changes_;
  QBoxLayout* body_ = nullptr;
  QWidget* of_plan_ = nullptr;
  TuneSettingsPanel* of_controller_;
  std::shared_ptr<const Reading> program_;
  std::shared_ptr<const Job> plan_job_;  // of the plan that is shown
  std::shared_ptr<const toolpace::TuneResult> tuning_;
  std::shared_ptr<std::atomic<bool>> enough_;  // of the search that runs
  std::optional<std::size_t> used_, hovered_;  // of the front
  bool stale_ = false, outdated_ = true;       // the latter: what is shown was not looked at yet
  QString trouble_;
  Units units_;
};

}  // namespace toolpace::ui
