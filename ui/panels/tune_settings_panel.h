#pragma once
/// The best settings of the controller that the program runs on, found by its own model, shown and taken.

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <memory>
#include <optional>

#include "drawing/controlled.h"
#include "jobs/tune_service.h"
#include "models/controller_model.h"
#include "models/tuning_model.h"

namespace toolpace::ui {

/// Part of the page "Tune". A list of the controller's own settings: those that are ticked may change. What is taken is one undo step.
class TuneSettingsPanel : public QWidget {
  Q_OBJECT

 public:
  /// @param machine  whose limits no setting goes beyond, where that is wanted
  TuneSettingsPanel(ControllerModel& model, const TuningModel& machine, QWidget* parent = nullptr);

  void showController(const ControllerView& view);
  void search();
  bool isSearching() const { return service_.isRunning(); }
  /// What was found last; nothing before that.
  const std::optional<TunedSettings>& tuned() const { return tuned_; }
  bool isStale() const;  ///< what was found is of other settings, or of another program
  void retranslate();

 signals:
  void searched();  ///< to its end, or not

 private:
  void build();
  void connectParts();
  void take();
  void fill();
  std::vector<std::string> ticked() const;
  void showState();
  QString verdict() const;

  ControllerModel& model_;
  const TuningModel& machine_;
  TuneService service_;
  QPushButton *button_, *take_;
  QCheckBox* within_;
  QLabel* verdict_;
  QTableWidget* table_;
  std::shared_ptr<const Controlled> run_;  // on the settings as they are; null: not known yet
  std::shared_ptr<const Controlled> asked_;
  SharedControllerText taken_;  // what came of the settings that were found
  std::optional<TunedSettings> tuned_;
  QString trouble_;
};

}  // namespace toolpace::ui
