#include "actions.h"

#include <QWidget>

#include "models/presets.h"
#include "theme/icons.h"

namespace toolpace::studio {

Actions::Actions(QWidget* window) : QObject(window), window_(window) {
  open = add("openAction", "open", {QKeySequence::Open});
  save_program = add("saveProgramAction", "", {QKeySequence::Save});
  save_program_as = add("saveProgramAsAction", "", {QKeySequence("Ctrl+Shift+S")});
  reload = add("reloadAction", "reload", {QKeySequence(Qt::Key_F5)});
  open_example = add("openExampleAction", "");
  close_window = add("quitAction", "", {QKeySequence("Ctrl+Q")});
  export_setpoints = add("exportSetpointsAction", "export", {QKeySequence("Ctrl+E")});
  export_program = add("exportProgramAction", "", {QKeySequence("Ctrl+Shift+P")});
  open_trace = add("openTraceAction", "", {QKeySequence("Ctrl+Shift+O")});
  close_trace = add("closeTraceAction", "");
  export_pulses = add("exportPulsesAction", "", {QKeySequence("Ctrl+Shift+E")});
  axis_derivatives = addToggle("axisDerivativesAction", "");
  decimal_comma = addToggle("decimalCommaAction", "");
  export_picture = add("exportPictureAction", "");
  export_plots = add("exportPlotsAction", "");
  export_window = add("exportWindowAction", "");
  export_report = add("exportReportAction", "report", {QKeySequence("Ctrl+R")});
  print = add("printAction", "", {QKeySequence::Print});
  open_machine = add("openMachineAction", "machine", {QKeySequence("Ctrl+M")});
  save_machine = add("saveMachineAction", "", {QKeySequence("Ctrl+Shift+M")});
  save_machine_as = add("saveMachineAsAction", "");
  default_machine = add("defaultMachineAction", "");
  import_machine = add("importMachineAction", "");
  own_plan = addToggle("ownPlanAction", "");
  open_controller = add("openControllerAction", "", {QKeySequence("Ctrl+K")});
  save_settings = add("saveSettingsAction", "");
  save_settings_as = add("saveSettingsAsAction", "");
  try_settings = add("trySettingsAction", "");
  undo = add("undoAction", "undo", {QKeySequence("Ctrl+Z")});
  redo = add("redoAction", "redo", {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  find = add("findAction", "search", {QKeySequence::Find});
  go_to = add("goToAction", "", {QKeySequence("Ctrl+G")});
  edit_line = add("editLineAction", "", {QKeySequence("Ctrl+F2")});
  insert_line = add("insertLineAction", "", {QKeySequence("Ctrl+Return"), QKeySequence("Ctrl+Enter")});
  delete_lines = add("deleteLinesAction", "", {QKeySequence("Ctrl+Shift+K")});
  addPlan();
  addView();
  show_handbook = add("handbookAction", "", {QKeySequence(Qt::Key_F1)});
  show_keys = add("keysAction", "", {QKeySequence("Shift+F1")});
  about = add("aboutAction", "");
  retranslate();
}

void Actions::addPlan() {
  play = add("playAction", "play", {QKeySequence(Qt::Key_Space)});
  previous_line = add("previousLineAction", "previous", {QKeySequence(Qt::Key_Left)});
  next_line = add("nextLineAction", "next", {QKeySequence(Qt::Key_Right)});
  to_start = add("toStartAction", "first", {QKeySequence(Qt::Key_Home)});
  to_end = add("toEndAction", "last", {QKeySequence(Qt::Key_End)});
  cancel = add("cancelAction", "cancel", {QKeySequence("Ctrl+.")});
  next_problem = add("nextProblemAction", "warning", {QKeySequence("F8")});
  slowest_place = add("slowestPlaceAction", "", {QKeySequence("F9")});
  for (const auto& preset : ui::plan_presets())
    presets.push_back(add(("preset_" + std::string(preset.id) + "Action").c_str(), ""));
  pin = add("pinAction", "pin", {QKeySequence("Ctrl+B")});
  unpin = add("unpinAction", "", {QKeySequence("Ctrl+Shift+B")});
  swap = add("swapAction", "swap", {QKeySequence("Ctrl+T")});
  sweep = add("sweepAction", "sweep", {QKeySequence("Ctrl+L")});
  tune = add("tuneAction", "", {QKeySequence("Ctrl+J")});
  what_if = add("whatIfAction", "", {QKeySequence("Ctrl+I")});
  hold = add("holdAction", "pause", {QKeySequence("Ctrl+H")});
  no_hold = add("noHoldAction", "", {QKeySequence("Ctrl+Shift+H")});
}

void Actions::addView() {
  hold_heights = addToggle("holdHeightsAction", "");
  fit_cutting = addToggle("fitCuttingAction", "");
  line_times = addToggle("lineTimesAction", "");
  rapids = addToggle("rapidsAction", "");
  rapids->setChecked(true);
  fit = add("fitAction", "fit", {QKeySequence(Qt::Key_F)});
  view_xy = add("viewXyAction", "", {QKeySequence(Qt::Key_Z)});
  view_xz = add("viewXzAction", "", {QKeySequence(Qt::Key_Y)});
  view_yz = add("viewYzAction", "", {QKeySequence(Qt::Key_X)});
  view_zx = add("viewZxAction", "", {QKeySequence(Qt::Key_L)});
  view_iso = add("viewIsoAction", "", {QKeySequence(Qt::Key_I)});
  dark = addToggle("darkAction", "theme", {QKeySequence("Ctrl+D")});
  touch = addToggle("touchAction", "");
  inch = addToggle("inchAction", "", {QKeySequence("Ctrl+U")});
  per_minute = addToggle("perMinuteAction", "");
  english = addToggle("englishAction", "");
  chinese = addToggle("chineseAction", "");
  auto* languages = new QActionGroup(this);
  languages->addAction(english);
  languages->addAction(chinese);
  reset_layout = add("resetLayoutAction", "panels");
}

QAction* Actions::add(const char* name, const char* icon, const QList<QKeySequence>& keys) {
  auto* action = new QAction(this);
  action->setObjectName(name);
  action->setProperty("icon_name", icon);
  action->setShortcuts(keys);
  window_->addAction(action);
  all_.push_back(action);
  return action;
}

QAction* Actions::addToggle(const char* name, const char* icon, const QList<QKeySequence>& keys) {
  auto* action = add(name, icon, keys);
  action->setCheckable(true);
  return action;
}

void Actions::setTheme(const ui::Theme& theme) {
  for (auto* action : all_) {
    const QString name = action->property("icon_name").toString();
    if (!name.isEmpty()) action->setIcon(ui::icon(name, theme));
  }
}

void Actions::retranslate() {
  open->setText(tr("&Open…"));
  open->setIconText(tr("Open"));
  save_program->setText(tr("&Save"));
  save_program_as->setText(tr("Save &as…"));
  reload->setText(tr("&Reload"));
  open_example->setText(tr("Open the e&xample"));
  close_window->setText(tr("&Quit"));
  export_setpoints->setText(tr("&Setpoints…"));
  export_program->setText(tr("&Program for this controller…"));
  open_trace->setText(tr("Open &trace…"));
  close_trace->setText(tr("C&lose the trace"));
  export_pulses->setText(tr("Step p&ulses…"));
  axis_derivatives->setText(tr("Setpoints with v, a, j of each &axis"));
  decimal_comma->setText(tr("Semicolon files with &decimal comma"));
  export_picture->setText(tr("&Contour preview…"));
  export_plots->setText(tr("&Plots…"));
  export_window->setText(tr("&Window…"));
  export_report->setText(tr("&Report…"));
  export_report->setIconText(tr("Report"));
  print->setText(tr("&Print…"));
  open_machine->setText(tr("&Open machine…"));
  save_machine->setText(tr("&Save machine"));
  save_machine_as->setText(tr("Save machine &as…"));
  default_machine->setText(tr("&Default limits"));
  import_machine->setText(tr("&Import machine…"));
  own_plan->setText(tr("&Toolpace's plan"));
  open_controller->setText(tr("A &controller with its settings…"));
  save_settings->setText(tr("&Save settings"));
  save_settings_as->setText(tr("Save settings &as…"));
  try_settings->setText(tr("What would each setting &give?"));
  undo->setText(tr("&Undo"));
  redo->setText(tr("&Redo"));
  find->setText(tr("&Find in program"));
  go_to->setText(tr("&Go to…"));
  edit_line->setText(tr("&Edit line"));
  insert_line->setText(tr("&Insert a line"));
  delete_lines->setText(tr("&Delete the lines chosen"));
  play->setText(tr("&Play or pause"));
  previous_line->setText(tr("One line &back"));
  next_line->setText(tr("One line &on"));
  to_start->setText(tr("To the &start"));
  to_end->setText(tr("To the &end"));
  cancel->setText(tr("&Cancel"));
  next_problem->setText(tr("Next p&roblem"));
  slowest_place->setText(tr("Next place that &loses time"));
  pin->setText(tr("Pin this plan as &B"));
  unpin->setText(tr("Let &go of B"));
  swap->setText(tr("S&wap A and B"));
  sweep->setText(tr("Sweep the look-a&head"));
  tune->setText(tr("Find the &best settings"));
  what_if->setText(tr("Which setting he&lps most?"));
  hold->setText(tr("Feed &hold at the cursor"));
  no_hold->setText(tr("Take the feed h&old away"));
  fit->setText(tr("&Fit"));
  rapids->setText(tr("Show &rapids"));
  hold_heights->setText(tr("&Keep the heights of the plots"));
  fit_cutting->setText(tr("Heights of the plots fit the c&utting"));
  line_times->setText(tr("&Times beside the lines"));
  view_xy->setText(tr("View along &Z (XY)"));
  view_xz->setText(tr("View along &Y (XZ)"));
  view_yz->setText(tr("View along &X (YZ)"));
  view_zx->setText(tr("View as at a &lathe (ZX)"));
  view_iso->setText(tr("&Isometric view"));
  dark->setText(tr("&Dark theme"));
  touch->setText(tr("&Touch mode"));
  inch->setText(tr("Show &inches"));
  per_minute->setText(tr("Speeds a &minute"));
  english->setText("English");
  chinese->setText("简体中文");
  reset_layout->setText(tr("&Reset the layout"));
  show_handbook->setText(tr("&Handbook"));
  show_keys->setText(tr("&Keys"));
  about->setText(tr("&About Toolpace"));
  for (auto* action : all_) {
    QString tip = action->text().remove('&').remove("…");
    if (!action->shortcut().isEmpty()) tip += "  (" + action->shortcut().toString(QKeySequence::NativeText) + ")";
    action->setToolTip(tip);
  }
  for (std::size_t i = 0; i < presets.size(); ++i) {
    presets[i]->setText(ui::plan_presets()[i].title());
    presets[i]->setToolTip(ui::plan_presets()[i].tip());
  }
}

}  // namespace toolpace::studio
