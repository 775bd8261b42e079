/// Menus and tool bar.

#include <QDockWidget>
#include <QLayout>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "main_window.h"

namespace toolpace::studio {
namespace {

QToolButton* menu_button(const char* name, QMenu* menu, QToolBar* bar) {
  auto* button = new QToolButton(bar);
  button->setObjectName(name);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addWidget(button);
  return button;
}

}  // namespace

void MainWindow::buildMenus() {
  Actions& a = *actions_;
  menu_bar_ = new QMenuBar(this);
  menu_bar_->setObjectName("menuBar");
  menu_bar_->setNativeMenuBar(false);
  const auto menu = [this](const char* name) {
    auto* result = menu_bar_->addMenu(QString());
    result->setObjectName(name);
    return result;
  };
  recent_menu_ = new QMenu(this);
  machine_menu_ = new QMenu(this);
  runs_menu_ = new QMenu(this);
  export_menu_ = new QMenu(this);
  preset_menu_ = new QMenu(this);
  for (QAction* preset : a.presets) preset_menu_->addAction(preset);
  preset_menu_->setToolTipsVisible(true);
  language_menu_ = new QMenu(this);
  panels_menu_ = new QMenu(this);
  setpoint_menu_ = new QMenu(this);
  connect(setpoint_menu_, &QMenu::aboutToShow, this, &MainWindow::fillFormats);
  fillFormats();
  export_menu_->addActions({a.export_setpoints});
  export_menu_->addMenu(setpoint_menu_);
  export_menu_->addActions({a.axis_derivatives, a.decimal_comma, a.export_pulses});
  export_menu_->addSeparator();
  export_menu_->addActions({a.export_program});
  export_menu_->addSeparator();
  export_menu_->addActions({a.export_picture, a.export_plots, a.export_window, a.export_report});
  language_menu_->addActions({a.english, a.chinese});
  connect(recent_menu_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  connect(machine_menu_, &QMenu::aboutToShow, this, &MainWindow::fillMachines);

  file_menu_ = menu("fileMenu");
  file_menu_->addAction(a.open);
  file_menu_->addMenu(recent_menu_);
  file_menu_->addActions({a.open_example, a.open_trace, a.close_trace});
  file_menu_->addSeparator();
  file_menu_->addActions({a.save_program, a.save_program_as, a.reload});
  file_menu_->addSeparator();
  file_menu_->addMenu(machine_menu_);
  file_menu_->addActions({a.import_machine, docks_["readingDock"]->toggleViewAction()});
  file_menu_->addMenu(export_menu_);
  file_menu_->addAction(a.print);
  file_menu_->addSeparator();
  file_menu_->addAction(a.close_window);
  edit_menu_ = menu("editMenu");
  edit_menu_->addActions({a.undo, a.redo});
  edit_menu_->addSeparator();
  edit_menu_->addActions({a.find, a.go_to, a.edit_line, a.insert_line, a.delete_lines});
  plan_menu_ = menu("planMenu");
  plan_menu_->addActions({a.play, a.previous_line, a.next_line, a.to_start, a.to_end});
  plan_menu_->addSeparator();
  plan_menu_->addActions({a.next_problem, a.slowest_place});
  plan_menu_->addSeparator();
  plan_menu_->addMenu(preset_menu_);
  plan_menu_->addMenu(runs_menu_);
  plan_menu_->addActions({a.pin, a.swap, a.unpin});
  plan_menu_->addSeparator();
  plan_menu_->addActions({a.hold, a.no_hold});
  plan_menu_->addSeparator();
  plan_menu_->addActions({a.tune, a.what_if, a.sweep, a.cancel});
  plan_menu_->addSeparator();
  plan_menu_->addActions({docks_["tuneDock"]->toggleViewAction(), docks_["traceDock"]->toggleViewAction(),
                          docks_["singleMoveDock"]->toggleViewAction(), docks_["stepperDock"]->toggleViewAction(),
                          docks_["drivesDock"]->toggleViewAction(), docks_["spectrumDock"]->toggleViewAction()});
  view_menu_ = menu("viewMenu");
  view_menu_->addActions({a.fit, a.rapids, a.hold_heights, a.fit_cutting, a.line_times, a.view_xy, a.view_xz, a.view_yz,
                          a.view_zx, a.view_iso});
  view_menu_->addSeparator();
  view_menu_->addActions({a.dark, a.touch, a.inch, a.per_minute});
  view_menu_->addMenu(language_menu_);
  view_menu_->addSeparator();
  view_menu_->addMenu(panels_menu_);
  view_menu_->addAction(a.reset_layout);
  for (const auto* name : {"programDock", "plotsDock", "tuningDock", "resultsDock", "controllerDock", "limitsDock",
                           "lossDock", "sweepDock", "circleDock", "problemsDock"}) {
    panels_menu_->addAction(docks_[name]->toggleViewAction());
  }
  help_menu_ = menu("helpMenu");
  help_menu_->addActions({a.show_handbook, a.show_keys, a.about});
}

void MainWindow::buildToolBar() {
  Actions& a = *actions_;
  tool_bar_ = addToolBar(QString());
  tool_bar_->setObjectName("toolBar");
  tool_bar_->setMovable(false);
  tool_bar_->setIconSize({16, 16});
  tool_bar_->setContextMenuPolicy(Qt::PreventContextMenu);
  menu_bar_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  tool_bar_->addWidget(menu_bar_);
  tool_bar_->addSeparator();
  open_button_ = menu_button("openButton", recent_menu_, tool_bar_);
  open_button_->setPopupMode(QToolButton::MenuButtonPopup);
  open_button_->setDefaultAction(a.open);
  tool_bar_->addAction(a.reload);
  tool_bar_->addSeparator();
  unit_button_ = new QToolButton(tool_bar_);
  unit_button_->setObjectName("unitButton");
  connect(unit_button_, &QToolButton::clicked, a.inch, &QAction::trigger);
  tool_bar_->addWidget(unit_button_);
  speed_unit_button_ = new QToolButton(tool_bar_);
  speed_unit_button_->setObjectName("speedUnitButton");
  connect(speed_unit_button_, &QToolButton::clicked, a.per_minute, &QAction::trigger);
  tool_bar_->addWidget(speed_unit_button_);
  tool_bar_->addAction(a.dark);
  tool_bar_->addSeparator();
  machine_button_ = menu_button("machineButton", machine_menu_, tool_bar_);
  runs_button_ = menu_button("runsButton", runs_menu_, tool_bar_);
  tool_bar_->addSeparator();
  tool_bar_->addActions({a.undo, a.redo});
  tool_bar_->addSeparator();
  export_button_ = menu_button("exportButton", export_menu_, tool_bar_);
  tool_bar_->addAction(a.export_report);
}

/// In a narrow window words make way before a button does.
void MainWindow::fitToolBar() {
  const QString star = controller_file_.isModified() ? "*" : "";
  const bool is_chosen = workspace_.controllerView().chosen != nullptr;
  const QString whole = tr("Runs on %1").arg(controllerName()), brief = is_chosen ? controllerName() : tr("Runs on");
  const auto is_too_wide = [this] { return tool_bar_->layout()->sizeHint().width() > width(); };
  export_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  machine_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  runs_button_->setText(whole + star);
  if (is_too_wide()) runs_button_->setText(brief + star);
  if (is_too_wide()) export_button_->setToolButtonStyle(Qt::ToolButtonIconOnly);
  if (is_too_wide()) machine_button_->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void MainWindow::fillRecent() {
  recent_menu_->clear();
  for (const QString& path : std::as_const(preferences_.recent_programs)) {
    recent_menu_->addAction(path, this, [this, path] { openProgram(path); });
  }
  if (preferences_.recent_programs.isEmpty()) recent_menu_->addAction(tr("nothing opened yet"))->setEnabled(false);
  recent_menu_->addSeparator();
  recent_menu_->addActions({actions_->open_example, actions_->open_trace});
}

void MainWindow::fillMachines() {
  machine_menu_->clear();
  for (const auto& machine : built_in_machines()) {
    machine_menu_->addAction(machine.name, this, [this, path = machine.path] { chooseMachine(path); });
  }
  machine_menu_->addAction(actions_->default_machine);
  if (!preferences_.recent_machines.isEmpty()) machine_menu_->addSeparator();
  for (const QString& path : std::as_const(preferences_.recent_machines)) {
    machine_menu_->addAction(path, this, [this, path] { chooseMachine(path); });
  }
  machine_menu_->addSeparator();
  machine_menu_->addActions({actions_->open_machine, actions_->save_machine, actions_->save_machine_as});
}

}  // namespace toolpace::studio
