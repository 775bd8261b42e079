#pragma once
/// The NC program with a bar to find a text or a place, what is modal at the cursor line, and a question where file and text part.

#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <array>

#include "drawing/plan_view.h"
#include "panels/change_bar.h"
#include "panels/modal_strip.h"
#include "panels/nc_view.h"
#include "theme/line_key.h"

namespace toolpace::ui {

class NcPanel : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit NcPanel(QWidget* parent = nullptr);

  NcView& view() { return *view_; }
  ChangeBar& changeBar() { return *change_bar_; }
  void showPlans(const Planned& plan, const Planned& pinned) override;
  void showController(const ControllerView& view) override;
  void setTimesShown(bool shown);  ///< what each line takes, beside it
  void setTheme(const Theme& theme) override;
  void setUnits(Units unit) override;
  void setColourMap(ColourMap map);
  void openFindBar();
  void openGoToBar();
  /// Shows below the text that a program can be dropped here.
  void setHintVisible(bool visible);

 signals:
  void lineRequested(int line);
  void timeRequested(double time);  ///< [s]

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Bar { find, go_to };

  void openBar(Bar bar);
  void find(bool backwards);
  void goTo();
  void retranslate();

  void showModal(int line);
  void fillKey();
  void showTimes();
  QLabel* times_;  // whose times stand beside the lines
  bool has_times_ = true;
  std::shared_ptr<const Controlled> found_;
  std::shared_ptr<const Timeline> timeline_;
  ChangeBar* change_bar_;
  NcView* view_;
  LineKey* key_;  // of the bars beside the lines
  ModalStrip* modal_;
  QWidget* bar_;
  QLineEdit* text_;
  QLabel *none_, *hint_;
  Theme theme_ = light_theme();
  Bar asks_ = Bar::find;
  std::array<QString, 2> asked_;  // what was last typed into each
};

}  // namespace toolpace::ui
