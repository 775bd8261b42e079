#pragma once
/// Everything that decides the plan: law, limits along the path, look-ahead, corners, overrides, axes.

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <array>
#include <functional>
#include <vector>

#include "drawing/plan_view.h"
#include "models/program_tolerance.h"
#include "models/tuning_model.h"
#include "panels/axes_grid.h"
#include "panels/form_grid.h"
#include "panels/lookahead_field.h"
#include "toolpace/pipeline/settings.h"

namespace toolpace::ui {

class TuningPanel : public QScrollArea, public PlanView {
  Q_OBJECT

 public:
  explicit TuningPanel(TuningModel& model, QWidget* parent = nullptr);

  /// What the plan had no use for is shown, but not to be edited, with the reason.
  void showPlans(const Planned& plan, const Planned& pinned) override;
  void setUnits(Units unit) override;
  void setRotaryAxes(const std::array<bool, 3>& turned);  ///< by the program; the machine's own have rows, too

  void setHead(QWidget* head);  ///< above all parameters; becomes a part of it

  QSize minimumSizeHint() const override;  ///< no row is cut off

  /// With which nothing has to be scrolled [px].
  int wholeHeight() const;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Entry {
    NumberField* field;
    QLabel* label;
    std::function<double(const Tuning&)> read;
    std::function<void(Tuning&, double)> write;
    std::function<QString()> title;   ///< full name, for people and undo
    std::function<QString()> symbol;  ///< short label; none = the title
  };

  NumberField* addNumber(const char* name, int row, int side, Quantity quantity, NumberField::Range range);
  void describe(std::function<double(const Tuning&)> read, std::function<void(Tuning&, double)> write,
                std::function<QString()> title, std::function<QString()> symbol = {});
  void buildLaw();
  void buildLimits();
  void buildCorner();
  void buildJob();
  void connectGestures(NumberField* field);
  void showValues();
  void showRelevant();
  void showProgramTolerance();
  void retranslate();

  TuningModel& model_;
  FormGrid* form_;
  std::vector<Entry> entries_;
  NumberField* last_ = nullptr;
  QLabel* last_label_ = nullptr;
  QComboBox *law_, *ramps_, *corner_;
  QLabel *law_label_ = nullptr, *lookahead_label_ = nullptr, *ramps_label_ = nullptr, *corner_label_ = nullptr;
  LookaheadField* lookahead_;
  AxesGrid* axes_;
  std::array<bool, 3> turned_ = {};
  Settings ignored_;                            ///< by a plan
  CornerRule ignored_rule_ = CornerRule::stop;  ///< with this corner rule
  std::shared_ptr<const Reading> program_;      ///< of the plan
  ProgramTolerance program_tolerance_;
  QLabel* program_note_ = nullptr;
  Units units_;
  NumberField *t_acc_, *t_dec_, *jerk_, *jerk_deceleration_, *tolerance_, *deviation_;
};

}  // namespace toolpace::ui
