#pragma once
/// Everything a person can ask the window for, each with name, shortcut and icon.

#include <QAction>
#include <QActionGroup>
#include <QObject>
#include <vector>

#include "theme/theme.h"

namespace toolpace::studio {

class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QWidget* window);

  void retranslate();
  void setTheme(const ui::Theme& theme);

  QAction *open, *save_program, *save_program_as, *reload, *open_example, *close_window;
  QAction *export_setpoints, *export_pulses, *axis_derivatives, *decimal_comma, *export_picture, *export_plots,
      *export_window, *export_report;
  QAction *open_machine, *save_machine, *save_machine_as, *default_machine, *import_machine;
  QAction *own_plan, *open_controller, *save_settings, *save_settings_as, *try_settings;
  QAction *undo, *redo, *find, *go_to, *edit_line, *insert_line, *delete_lines;
  QAction *play, *previous_line, *next_line, *to_start, *to_end, *cancel, *next_problem, *slowest_place;
  QAction *fit, *view_xy, *view_xz, *view_yz, *view_zx, *view_iso;
  std::vector<QAction*> presets;  ///< of ui::plan_presets(), in their order
  QAction *pin, *unpin, *swap, *sweep, *tune, *what_if, *export_program, *open_trace, *close_trace, *hold, *no_hold;
  QAction *dark, *touch, *inch, *per_minute, *hold_heights, *fit_cutting, *line_times, *rapids, *print, *english,
      *chinese, *reset_layout;
  QAction *show_handbook, *show_keys, *about;

 private:
  QAction* add(const char* name, const char* icon, const QList<QKeySequence>& keys = {});
  QAction* addToggle(const char* name, const char* icon, const QList<QKeySequence>& keys = {});
  void addPlan();
  void addView();

  QWidget* window_;
  std::vector<QAction*> all_;
};

}  // namespace toolpace::studio
