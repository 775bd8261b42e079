#include <QDockWidget>
#include <QLayout>
#include <QMenuBar>
#include <QResizeEvent>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "main_window.h"
#include "panels/change_bar.h"
#include "panels/circle_panel.h"
#include "panels/dock.h"
#include "panels/dock_title.h"
#include "panels/drives_page.h"
#include "panels/loss_panel.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/reading_page.h"
#include "panels/results_panel.h"
#include "panels/single_move_page.h"
#include "panels/stepper_page.h"
#include "panels/sweep_panel.h"
#include "panels/transport_bar.h"
#include "panels/tuning_panel.h"
#include "panels/what_if_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"

namespace toolpace::studio {
namespace {

constexpr int kProgramWidth = 240, kWidestProgram = 380, kRightWidth = 360, kTuningHeight = 396;
constexpr double kProgramShare = 0.16;  // of the width
constexpr double kPlotShare = 0.52;     // of the height below the tool bar
constexpr int kChrome = 80;             // tool bar and transport bar

QToolButton* menu_button(const char* name, QMenu* menu, QToolBar* bar) {
  auto* button = new QToolButton(bar);
  button->setObjectName(name);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addWidget(button);
  return button;
}

/// One below the other, without a gap.
void stack(std::initializer_list<QWidget*> widgets, QWidget* page) {
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (QWidget* widget : widgets) column->addWidget(widget, widget == widgets.end()[-1] ? 1 : 0);
}

}  // namespace

void MainWindow::buildPanels() {
  setDockOptions(AllowTabbedDocks | AllowNestedDocks | AnimatedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);

  contour_ = new ui::ContourView(this);
  if (contour_->objectName().isEmpty()) contour_->setObjectName("contourView");
  welcome_ = new ui::WelcomeBar(this);
  auto* middle = new QWidget(this);
  stack({welcome_, contour_}, middle);
  setCentralWidget(middle);
  nc_ = new ui::NcPanel(this);
  profile_ = new ui::ProfileView(this);
  auto* tuning_page = new QWidget(this);
  machine_bar_ = new ui::ChangeBar("machineBar", tuning_page);
  tuning_ = new ui::TuningPanel(workspace_.tuning(), tuning_page);
  stack({machine_bar_, tuning_}, tuning_page);
  results_ = new ui::ResultsPanel(this);
  what_if_ = new ui::WhatIfPanel(this);
  loss_ = new ui::LossPanel(this);
  sweep_ = new ui::SweepPanel(this);
  circle_ = new ui::CirclePanel(this);
  problems_ = new ui::ProblemsPanel(this);
  addDock("programDock", nc_, Qt::LeftDockWidgetArea, true);
  addDock("plotsDock", profile_, Qt::BottomDockWidgetArea, false);
  addDock("tuningDock", tuning_page, Qt::RightDockWidgetArea, true);
  addDock("resultsDock", results_, Qt::RightDockWidgetArea, false);
  addDock("limitsDock", what_if_, Qt::RightDockWidgetArea, false);
  addDock("lossDock", loss_, Qt::RightDockWidgetArea, false);
  addDock("sweepDock", sweep_, Qt::RightDockWidgetArea, false);
  addDock("circleDock", circle_, Qt::RightDockWidgetArea, false);
  addDock("problemsDock", problems_, Qt::RightDockWidgetArea, false);
  single_move_ = new ui::SingleMovePage(this);
  stepper_ = new ui::StepperPage(this);
  stepper_->setOutputCheck([this](const QString& file) { return checkOutput(file, Output::exported); });
  addTool("singleMoveDock", single_move_, {900, 560});
  addTool("stepperDock", stepper_, {900, 560});
  drives_ = new ui::DrivesPage(workspace_.tuning(), this);
  reading_ = new ui::ReadingPage(this);
  addTool("drivesDock", drives_, {640, 340});
  addTool("readingDock", reading_, {520, 420});
  arrange();
  first_layout_ = saveState();

  transport_ = new ui::TransportBar(this);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(0, 0, 0, 0);
  statusBar()->addWidget(transport_, 1);
  plan_views_ = {nc_, contour_, profile_, tuning_, results_, what_if_, loss_, sweep_, circle_, drives_, transport_};
}

QDockWidget* MainWindow::addDock(const char* name, QWidget* content, Qt::DockWidgetArea area, bool titled) {
  auto* dock = new ui::Dock(this);
  dock->setObjectName(name);
  dock->setWidget(content);
  titles_[name] = new ui::DockTitle(dock, titled);
  dock->setTitleBarWidget(titles_[name]);
  addDockWidget(area, dock);
  docks_[name] = dock;
  return dock;
}

// A page beside the program: a window of its own until somebody docks it.
void MainWindow::addTool(const char* name, QWidget* page, const QSize& size) {
  auto* dock = addDock(name, page, Qt::BottomDockWidgetArea, true);
  dock->hide();  // first, or floating would show it
  dock->setFloating(true);
  dock->resize(size);
}

void MainWindow::arrange() {
  const std::vector<QString> tabs = {"limitsDock", "lossDock", "sweepDock", "circleDock", "problemsDock"};
  splitDockWidget(docks_["tuningDock"], docks_["resultsDock"], Qt::Vertical);
  for (const auto& tab : tabs) tabifyDockWidget(docks_["resultsDock"], docks_[tab]);
  docks_["resultsDock"]->raise();
  shareRoom();
}

// As at first. restoreState() shows each tab bar of a list at its end; the first that it shows activates the layout, which makes that list anew
// while it is being read. A layout that rests until all is done leaves the list alone.
void MainWindow::resetLayout() {
  layout()->setEnabled(false);
  restoreState(first_layout_);
  layout()->setEnabled(true);
  layout()->activate();
  shareRoom();
}

// Plots and preview share the height of the window, and the tuning gets what it needs.
void MainWindow::shareRoom() {
  program_share_.reset();
  plot_share_ = kPlotShare;
  resizeDocks({docks_["tuningDock"]}, {kRightWidth}, Qt::Horizontal);
  const int whole = std::max(height() - kChrome, 1);
  const int tuning = std::min(kTuningHeight * (preferences_.touch ? 2 : 1), whole * 3 / 5);
  resizeDocks({docks_["tuningDock"], docks_["resultsDock"]}, {tuning, whole - tuning}, Qt::Vertical);
  giveShares();
}

/// What is made smaller together with the window grows with it again.
void MainWindow::giveShares() {
  const int usual = std::clamp(static_cast<int>(width() * kProgramShare), kProgramWidth, kWidestProgram);
  const int program = program_share_ ? static_cast<int>(width() * *program_share_) : usual;
  if (!docks_["programDock"]->isFloating()) resizeDocks({docks_["programDock"]}, {program}, Qt::Horizontal);
  const int plots = static_cast<int>(std::max(height() - kChrome, 1) * plot_share_);
  if (!docks_["plotsDock"]->isFloating()) resizeDocks({docks_["plotsDock"]}, {plots}, Qt::Vertical);
}

/// Width of the program, height of the plots.
QSize MainWindow::sharedSizes() const { return {docks_.at("programDock")->width(), docks_.at("plotsDock")->height()}; }

/// After a border was dragged, and of a layout that was kept.
void MainWindow::rememberShares() {
  const QDockWidget &program = *docks_["programDock"], &plots = *docks_["plotsDock"];
  if (program.isVisible() && !program.isFloating()) program_share_ = static_cast<double>(program.width()) / width();
  if (plots.isVisible() && !plots.isFloating() && height() > kChrome)
    plot_share_ = static_cast<double>(plots.height()) / (height() - kChrome);
}

// Rows of rotary axes need more room than the tuning was given; where there is some, the results below it give it.
void MainWindow::showWholeTuning() {
  QDockWidget &tuning = *docks_["tuningDock"], &results = *docks_["resultsDock"];
  if (tuning.isFloating() || results.isFloating() || !tuning.isVisible()) return;
  const int both = tuning.height() + results.height(), frame = tuning.height() - tuning_->height();
  const int wanted = std::min(tuning_->wholeHeight() + frame, both / 2);
  if (wanted > tuning.height()) resizeDocks({&tuning, &results}, {wanted, both - wanted}, Qt::Vertical);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  showWelcome();
  if (event->oldSize().height() > 0) return giveShares();
  if (preferences_.layout.isEmpty()) return shareRoom();
  QMetaObject::invokeMethod(this, &MainWindow::rememberShares, Qt::QueuedConnection);
}

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
  export_menu_->addActions({a.export_picture, a.export_plots, a.export_window, a.export_report});
  language_menu_->addActions({a.english, a.chinese});
  connect(recent_menu_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  connect(machine_menu_, &QMenu::aboutToShow, this, &MainWindow::fillMachines);

  file_menu_ = menu("fileMenu");
  file_menu_->addAction(a.open);
  file_menu_->addMenu(recent_menu_);
  file_menu_->addAction(a.open_example);
  file_menu_->addSeparator();
  file_menu_->addActions({a.save_program, a.save_program_as, a.reload});
  file_menu_->addSeparator();
  file_menu_->addMenu(machine_menu_);
  file_menu_->addActions({a.import_machine, docks_["readingDock"]->toggleViewAction()});
  file_menu_->addMenu(export_menu_);
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
  plan_menu_->addActions({a.pin, a.swap, a.unpin});
  plan_menu_->addSeparator();
  plan_menu_->addActions({a.hold, a.no_hold});
  plan_menu_->addSeparator();
  plan_menu_->addActions({a.sweep, a.what_if, a.cancel});
  plan_menu_->addSeparator();
  plan_menu_->addActions({docks_["singleMoveDock"]->toggleViewAction(), docks_["stepperDock"]->toggleViewAction(),
                          docks_["drivesDock"]->toggleViewAction()});
  view_menu_ = menu("viewMenu");
  view_menu_->addActions({a.fit, a.view_xy, a.view_xz, a.view_yz, a.view_zx, a.view_iso});
  view_menu_->addSeparator();
  view_menu_->addActions({a.dark, a.touch, a.inch});
  view_menu_->addMenu(language_menu_);
  view_menu_->addSeparator();
  view_menu_->addMenu(panels_menu_);
  view_menu_->addAction(a.reset_layout);
  for (const auto* name : {"programDock", "plotsDock", "tuningDock", "resultsDock", "limitsDock", "lossDock",
                           "sweepDock", "circleDock", "problemsDock"}) {
    panels_menu_->addAction(docks_[name]->toggleViewAction());
  }
  help_menu_ = menu("helpMenu");
  help_menu_->addActions({a.show_keys, a.about});
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
  tool_bar_->addAction(a.dark);
  tool_bar_->addSeparator();
  machine_button_ = menu_button("machineButton", machine_menu_, tool_bar_);
  tool_bar_->addSeparator();
  tool_bar_->addActions({a.undo, a.redo});
  tool_bar_->addSeparator();
  export_button_ = menu_button("exportButton", export_menu_, tool_bar_);
  tool_bar_->addAction(a.export_report);
}

void MainWindow::fillRecent() {
  recent_menu_->clear();
  for (const QString& path : std::as_const(preferences_.recent_programs)) {
    recent_menu_->addAction(path, this, [this, path] { openProgram(path); });
  }
  if (preferences_.recent_programs.isEmpty()) recent_menu_->addAction(tr("nothing opened yet"))->setEnabled(false);
  recent_menu_->addSeparator();
  recent_menu_->addAction(actions_->open_example);
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
