#include <QDockWidget>
#include <QUndoStack>

#include "main_window.h"
#include "panels/circle_panel.h"
#include "panels/controller_panel.h"
#include "panels/dock_title.h"
#include "panels/loss_panel.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/reading_page.h"
#include "panels/results_panel.h"
#include "panels/spectrum_page.h"
#include "panels/sweep_panel.h"
#include "panels/trace_page.h"
#include "panels/transport_bar.h"
#include "panels/tune_page.h"
#include "panels/tuning_panel.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"

namespace toolpace::studio {

void MainWindow::connectWorkspace() {
  using ui::Workspace;
  connect(&workspace_, &Workspace::documentChanged, this, &MainWindow::showDocument);
  connect(&workspace_, &Workspace::documentChanged, this, [this](bool another) {
    if (another) forgetFailure();
  });
  connectProgram();
  connectMachine();
  connectController();
  connectTrace();
  connect(&workspace_, &Workspace::planChanged, this, &MainWindow::showPlan);
  connect(&workspace_, &Workspace::pinnedChanged, this, &MainWindow::showPlans);
  connect(&workspace_, &Workspace::proofChanged, this, &MainWindow::showPlans);
  connect(&workspace_, &Workspace::problemsChanged, this, &MainWindow::showProblems);
  connect(&workspace_.tuning().undoStack(), &QUndoStack::indexChanged, this, &MainWindow::forgetFailure);
  connect(&workspace_, &Workspace::cursorChanged, this, &MainWindow::showCursor);
  connect(&workspace_, &Workspace::openFailed, this, &MainWindow::showFailure);
  connect(&workspace_, &Workspace::busyChanged, transport_, &ui::TransportBar::setBusy);
  connect(&workspace_, &Workspace::progressed, transport_, &ui::TransportBar::setProgress);
  connect(&workspace_, &Workspace::staleChanged, this, &MainWindow::showState);
  connect(&workspace_, &Workspace::refinementChanged, this, &MainWindow::showState);
  connect(&workspace_.playback(), &ui::Playback::playingChanged, transport_, &ui::TransportBar::setPlaying);
}

void MainWindow::connectPanels() {
  const auto go_to_line = [this](int line) {
    following_ = false;  // the line that was chosen stays chosen, even where it does not move
    workspace_.setCursorLine(static_cast<std::uint32_t>(line));
    following_ = true;
  };
  connect(&nc_->view(), &ui::NcView::lineActivated, this, go_to_line);
  const auto show_line = [this, go_to_line](int line) {
    nc_->view().setCurrentLine(line);
    go_to_line(line);
  };
  connect(nc_, &ui::NcPanel::lineRequested, this, show_line);
  connect(nc_, &ui::NcPanel::timeRequested, &workspace_, &ui::Workspace::setCursorTime);
  connect(problems_, &ui::ProblemsPanel::lineRequested, this, show_line);
  connect(problems_, &ui::ProblemsPanel::actionRequested, this, &MainWindow::remedy);
  connect(reading_, &ui::ReadingPage::optionsChanged, this, [this] { workspace_.setReadOptions(reading_->options()); });
  connect(welcome_, &ui::WelcomeBar::tried, this, &MainWindow::tryOut);
  connect(welcome_, &ui::WelcomeBar::dismissed, this, [this] {
    preferences_.welcomed = true;
    showWelcome();
  });
  connect(&workspace_.tuning(), &ui::TuningModel::changed, this, &MainWindow::showRotaryAxes);
  connect(loss_, &ui::LossPanel::lineRequested, this, show_line);
  connect(trace_, &ui::TracePage::lineRequested, this, show_line);
  connect(contour_, &ui::ContourView::cursorTimeRequested, &workspace_, &ui::Workspace::setCursorTime);
  connect(contour_, &ui::ContourView::colourByChanged, &workspace_, &ui::Workspace::setShown);
  connect(contour_, &ui::ContourView::colourMapChanged, this, [this](ui::ColourMap map) {
    preferences_.colour_map = ui::colour_map_name(map);
    nc_->setColourMap(map);
  });
  connect(circle_, &ui::CirclePanel::cursorTimeRequested, &workspace_, &ui::Workspace::setCursorTime);
  connect(profile_, &ui::ProfileView::cursorTimeRequested, &workspace_, &ui::Workspace::setCursorTime);
  connect(profile_, &ui::ProfileView::visibleRangeChanged, spectrum_, &ui::SpectrumPage::setVisibleTime);
  connect(profile_, &ui::ProfileView::axesShown, &workspace_, &ui::Workspace::setShownAxes);
  connect(&workspace_, &ui::Workspace::axesReady, profile_, &ui::ProfileView::showReadyAxes);
  connect(results_, &ui::ResultsPanel::pinRequested, &workspace_, &ui::Workspace::pin);
  connect(results_, &ui::ResultsPanel::unpinRequested, &workspace_, &ui::Workspace::unpin);
  connect(results_, &ui::ResultsPanel::checkRequested, &workspace_, &ui::Workspace::checkNow);
  connect(results_, &ui::ResultsPanel::stopCheckRequested, &workspace_, &ui::Workspace::stopChecking);
  connect(&workspace_, &ui::Workspace::proofStateChanged, results_, &ui::ResultsPanel::showProofState);
  connect(results_, &ui::ResultsPanel::swapRequested, &workspace_, &ui::Workspace::swap);
  connect(sweep_, &ui::SweepPanel::depthRequested, this, [this](std::optional<std::size_t> depth) {
    workspace_.tuning().edit(tr("Look-ahead"), "lookahead", [depth](ui::Tuning& t) { t.options.lookahead = depth; });
  });
  using ui::TransportBar;
  connect(transport_, &TransportBar::firstRequested, this, [this] { workspace_.setCursorTime(0); });
  connect(transport_, &TransportBar::lastRequested, this, [this] { workspace_.setCursorTime(1e300); });
  connect(transport_, &TransportBar::previousRequested, this, [this] { workspace_.stepLine(-1); });
  connect(transport_, &TransportBar::nextRequested, this, [this] { workspace_.stepLine(+1); });
  connect(transport_, &TransportBar::playRequested, &workspace_, &ui::Workspace::togglePlay);
  connect(transport_, &TransportBar::rateChanged, &workspace_.playback(), &ui::Playback::setRate);
  connect(transport_, &TransportBar::cancelRequested, &workspace_, &ui::Workspace::cancel);
}

void MainWindow::connectActions() {
  Actions& a = *actions_;
  const auto on = [this](QAction* action, auto slot) { connect(action, &QAction::triggered, this, slot); };
  on(a.open, [this] { askProgram(); });
  on(a.save_program, [this] { saveProgram(false); });
  on(a.save_program_as, [this] { saveProgram(true); });
  on(a.reload, [this] { workspace_.reload(); });
  on(a.open_example, [this] { openExample(); });
  on(a.close_window, [this] { close(); });
  on(a.export_setpoints, [this] { askExport(); });
  on(a.print, [this] { print(); });
  on(a.export_pulses, [this] { exportPulses(); });
  on(a.export_program, [this] { askRewrite(); });
  on(a.open_trace, [this] { askTrace(); });
  on(a.close_trace, [this] { closeTrace(); });
  a.close_trace->setEnabled(false);
  on(a.axis_derivatives, [this](bool with) { preferences_.axis_derivatives = with; });
  on(a.decimal_comma, [this](bool with) { preferences_.decimal_comma = with; });
  a.axis_derivatives->setChecked(preferences_.axis_derivatives);
  a.decimal_comma->setChecked(preferences_.decimal_comma);
  on(a.export_picture, [this] { exportPicture(Picture::contour); });
  on(a.export_plots, [this] { exportPicture(Picture::plots); });
  on(a.export_window, [this] { exportPicture(Picture::window); });
  on(a.export_report, [this] { exportReport(); });
  on(a.open_machine, [this] { askMachine(); });
  on(a.save_machine, [this] { saveMachine(false); });
  on(a.save_machine_as, [this] { saveMachine(true); });
  on(a.import_machine, [this] { importMachine(); });
  on(a.own_plan, [this] { leaveController(); });
  on(a.open_controller, [this] { askController(); });
  on(a.save_settings, [this] { saveSettings(false); });
  on(a.save_settings_as, [this] { saveSettings(true); });
  on(a.try_settings, [this] {
    docks_["controllerDock"]->show();
    docks_["controllerDock"]->raise();
    controller_->compute();
  });
  a.try_settings->setEnabled(false);
  for (std::size_t i = 0; i < a.presets.size(); ++i) on(a.presets[i], [this, i] { usePreset(i); });
  on(a.default_machine, [this] { chooseDefaultMachine(); });
  auto& undo = workspace_.undoStack();
  on(a.undo, [&undo] { undo.undo(); });
  on(a.redo, [&undo] { undo.redo(); });
  connect(&undo, &QUndoStack::canUndoChanged, a.undo, &QAction::setEnabled);
  connect(&undo, &QUndoStack::canRedoChanged, a.redo, &QAction::setEnabled);
  a.undo->setEnabled(false);
  a.redo->setEnabled(false);
  on(a.find, [this] { nc_->openFindBar(); });
  on(a.go_to, [this] { nc_->openGoToBar(); });
  on(a.edit_line, [this] { nc_->view().editCurrentLine(); });
  on(a.insert_line, [this] { nc_->view().insertLine(); });
  on(a.delete_lines, [this] { nc_->view().removeLines(); });
  on(a.play, [this] { workspace_.togglePlay(); });
  on(a.previous_line, [this] { workspace_.stepLine(-1); });
  on(a.next_line, [this] { workspace_.stepLine(+1); });
  on(a.to_start, [this] { workspace_.setCursorTime(0); });
  on(a.to_end, [this] { workspace_.setCursorTime(1e300); });
  on(a.cancel, [this] { workspace_.cancel(); });
  on(a.next_problem, [this] { goToProblem(); });
  on(a.slowest_place, [this] { goToSlowest(); });
  on(a.pin, [this] { workspace_.pin(); });
  on(a.unpin, [this] { workspace_.unpin(); });
  on(a.swap, [this] { workspace_.swap(); });
  on(a.sweep, [this] {
    docks_["sweepDock"]->show();
    docks_["sweepDock"]->raise();
    sweep_->compute();
  });
  const auto show_tune = [this] {
    docks_["tuneDock"]->show();
    docks_["tuneDock"]->raise();
  };
  on(a.tune, [this, show_tune] {
    show_tune();
    tune_->search();
  });
  on(a.what_if, [this, show_tune] {
    show_tune();
    tune_->changes().compute();
  });
  on(a.hold, [this] { holdAt(workspace_.cursorTime()); });
  on(a.no_hold, [this] { holdAt(std::nullopt); });
  on(a.rapids, [this](bool shown) {
    preferences_.rapids = shown;
    contour_->setRapidsShown(shown);
  });
  a.rapids->setChecked(preferences_.rapids);
  contour_->setRapidsShown(preferences_.rapids);
  on(a.line_times, [this](bool shown) {
    preferences_.line_times = shown;
    nc_->setTimesShown(shown);
  });
  a.line_times->setChecked(preferences_.line_times);
  nc_->setTimesShown(preferences_.line_times);
  on(a.fit_cutting, [this](bool cutting) { profile_->plot().setHeightsOfCutting(cutting); });
  on(a.hold_heights, [this](bool held) { profile_->plot().setHeightsHeld(held); });
  connect(&profile_->plot(), &ui::ProfilePlot::heightsHeld, a.hold_heights, &QAction::setChecked);
  on(a.fit, [this] { contour_->fit(), profile_->fit(); });
  on(a.view_xy, [this] { contour_->setView(ui::View::xy); });
  on(a.view_xz, [this] { contour_->setView(ui::View::xz); });
  on(a.view_yz, [this] { contour_->setView(ui::View::yz); });
  on(a.view_zx, [this] { contour_->setView(ui::View::zx); });
  on(a.view_iso, [this] { contour_->setView(ui::View::iso); });
  on(a.dark, [this](bool dark) { setDark(dark); });
  on(a.touch, [this](bool touch) { setTouch(touch); });
  on(a.inch, [this](bool inch) { setInch(inch); });
  on(a.per_minute, [this](bool per_minute) { setPerMinute(per_minute); });
  on(a.english, [this] { setLanguage("en"); });
  on(a.chinese, [this] { setLanguage("zh_CN"); });
  on(a.reset_layout, [this] { resetLayout(); });
  on(a.show_handbook, [this] { showHandbook(); });
  on(a.show_keys, [this] { showKeys(); });
  on(a.about, [this] { showAbout(); });
}

}  // namespace toolpace::studio
