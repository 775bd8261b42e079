#include <QDockWidget>
#include <QLayout>
#include <QResizeEvent>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>

#include "main_window.h"
#include "panels/causes_panel.h"
#include "panels/change_bar.h"
#include "panels/circle_panel.h"
#include "panels/controller_panel.h"
#include "panels/controller_section.h"
#include "panels/dock.h"
#include "panels/dock_title.h"
#include "panels/drives_page.h"
#include "panels/loss_panel.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/reading_page.h"
#include "panels/results_panel.h"
#include "panels/single_move_page.h"
#include "panels/spectrum_page.h"
#include "panels/stepper_page.h"
#include "panels/sweep_panel.h"
#include "panels/trace_page.h"
#include "panels/transport_bar.h"
#include "panels/tune_page.h"
#include "panels/tuning_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"

namespace toolpace::studio {
namespace {

constexpr int kProgramWidth = 240, kWidestProgram = 380, kRightWidth = 360, kTuningHeight = 396;
constexpr double kProgramShare = 0.16;  // of the width
constexpr double kPlotShare = 0.52;     // of the height below the tool bar
constexpr int kChrome = 80;             // tool bar and transport bar

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
  buildController(tuning_page);
  stack({machine_bar_, settings_bar_, tuning_}, tuning_page);
  results_ = new ui::ResultsPanel(this);
  causes_ = new ui::CausesPanel(this);
  loss_ = new ui::LossPanel(this);
  sweep_ = new ui::SweepPanel(this);
  circle_ = new ui::CirclePanel(this);
  problems_ = new ui::ProblemsPanel(this);
  addDock("programDock", nc_, Qt::LeftDockWidgetArea, true);
  addDock("plotsDock", profile_, Qt::BottomDockWidgetArea, false);
  addDock("tuningDock", tuning_page, Qt::RightDockWidgetArea, true);
  addDock("resultsDock", results_, Qt::RightDockWidgetArea, false);
  addDock("controllerDock", controller_, Qt::RightDockWidgetArea, false);
  addDock("limitsDock", causes_, Qt::RightDockWidgetArea, false);
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
  spectrum_ = new ui::SpectrumPage(this);
  trace_ = new ui::TracePage(this);
  addTool("traceDock", trace_, {640, 560});
  tune_ = new ui::TunePage(workspace_.tuning(), workspace_.controller(), this);
  addTool("tuneDock", tune_, {1000, 620});
  addTool("spectrumDock", spectrum_, {760, 560});
  addTool("drivesDock", drives_, {640, 340});
  addTool("readingDock", reading_, {520, 420});
  arrange();
  first_layout_ = saveState();

  transport_ = new ui::TransportBar(this);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(0, 0, 0, 0);
  statusBar()->addWidget(transport_, 1);
  plan_views_ = {nc_,    contour_, profile_, tuning_,   results_, controller_, causes_,   loss_,
                 sweep_, circle_,  drives_,  spectrum_, tune_,    trace_,      transport_};
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
  const std::vector<QString> tabs = {"controllerDock", "limitsDock", "lossDock",
                                     "sweepDock",      "circleDock", "problemsDock"};
  splitDockWidget(docks_["tuningDock"], docks_["resultsDock"], Qt::Vertical);
  for (const auto& tab : tabs) tabifyDockWidget(docks_["resultsDock"], docks_[tab]);
  docks_["controllerDock"]->hide();
  docks_["resultsDock"]->raise();
  shareRoom();
}

// As at first. restoreState() shows each tab bar of a list at its end; the first that it shows activates the layout, which
// makes that list anew while it is being read. A layout that rests until all is done leaves the list alone.
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
  fitToolBar();
  if (event->oldSize().height() > 0) return giveShares();
  if (preferences_.layout.isEmpty()) return shareRoom();
  QMetaObject::invokeMethod(this, &MainWindow::rememberShares, Qt::QueuedConnection);
}

}  // namespace toolpace::studio
