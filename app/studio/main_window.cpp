#include "main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QLibraryInfo>
#include <QLocale>
#include <QMimeData>
#include <QSlider>
#include <QTableView>
#include <QToolBar>
#include <algorithm>

#include "panels/dock_title.h"
#include "panels/loss_panel.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/results_panel.h"
#include "panels/single_move_page.h"
#include "panels/stepper_page.h"
#include "panels/sweep_panel.h"
#include "panels/transport_bar.h"
#include "panels/tuning_panel.h"
#include "panels/what_if_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "theme/appearance.h"
#include "theme/icons.h"

namespace toolpace::studio {
namespace {

constexpr auto kExample = ":/butterfly.ngc";

bool uses_rotary(const Moves& moves) {
  const AxisVector& at = moves.start;
  for (const auto& end : moves.end) {
    if (end.tail<3>() != at.tail<3>()) return true;
  }
  return false;
}

}  // namespace

MainWindow::MainWindow(bool remember)
    : remember_(remember), preferences_(remember ? load_preferences() : Preferences{}), actions_(new Actions(this)) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  buildPanels();
  buildMenus();
  buildToolBar();
  connectWorkspace();
  connectPanels();
  connectActions();
  connectExporter();
  qApp->installEventFilter(this);
  setLanguage(preferences_.language.isEmpty() ? QLocale::system().name() : preferences_.language);
  actions_->dark->setChecked(preferences_.dark);
  actions_->touch->setChecked(preferences_.touch);
  applyAppearance();
  setInch(preferences_.inch);
  if (!preferences_.geometry.isEmpty()) restoreGeometry(preferences_.geometry);
  if (!preferences_.layout.isEmpty()) restoreState(preferences_.layout);
  showProblems();
  nc_->view().setFocus();
}

MainWindow::~MainWindow() {
  qApp->removeEventFilter(this);
  // Taking a translator away retranslates everything, so it has to happen while everything is still there.
  QCoreApplication::removeTranslator(&translator_);
  QCoreApplication::removeTranslator(&qt_translator_);
}

void MainWindow::connectWorkspace() {
  using ui::Workspace;
  connect(&workspace_, &Workspace::documentChanged, this, &MainWindow::showDocument);
  connect(&workspace_, &Workspace::planChanged, this, &MainWindow::showPlan);
  connect(&workspace_, &Workspace::pinnedChanged, this, &MainWindow::showPinned);
  connect(&workspace_, &Workspace::proofChanged, this, [this] {
    contour_->setScene(workspace_.plan().proof->scene);
    profile_->setErrorTrace(workspace_.plan().proof->scene->trace);
    results_->setPlans(workspace_.plan(), workspace_.pinned());
  });
  connect(&workspace_, &Workspace::problemsChanged, this, &MainWindow::showProblems);
  connect(&workspace_, &Workspace::cursorChanged, this, &MainWindow::showCursor);
  connect(&workspace_, &Workspace::openFailed, this, &MainWindow::showFailure);
  connect(&workspace_, &Workspace::busyChanged, transport_, &ui::TransportBar::setBusy);
  connect(&workspace_, &Workspace::progressed, transport_, &ui::TransportBar::setProgress);
  connect(&workspace_, &Workspace::staleChanged, this, [this](bool stale) {
    for (const auto& [name, title] : titles_) title->setStale(stale && name == "tuningDock");
  });
  connect(&workspace_.playback(), &ui::Playback::playingChanged, transport_, &ui::TransportBar::setPlaying);
  connect(&workspace_.tuning().undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::showTitle);
}

void MainWindow::connectPanels() {
  const auto go_to_line = [this](int line) {
    following_ = false;  // the line that was chosen stays chosen, even where it does not move
    workspace_.setCursorLine(static_cast<std::uint32_t>(line));
    following_ = true;
  };
  connect(&nc_->view(), &ui::NcView::lineActivated, this, go_to_line);
  connect(&nc_->view(), &ui::NcView::lineEdited, &workspace_, &ui::Workspace::editLine);
  const auto show_line = [this, go_to_line](int line) {
    nc_->view().setCurrentLine(line);
    go_to_line(line);
  };
  connect(problems_, &ui::ProblemsPanel::lineRequested, this, show_line);
  connect(loss_, &ui::LossPanel::lineRequested, this, show_line);
  connect(contour_, &ui::ContourView::cursorTimeRequested, &workspace_, &ui::Workspace::setCursorTime);
  connect(profile_, &ui::ProfileView::cursorTimeRequested, &workspace_, &ui::Workspace::setCursorTime);
  connect(results_, &ui::ResultsPanel::pinRequested, &workspace_, &ui::Workspace::pin);
  connect(results_, &ui::ResultsPanel::unpinRequested, &workspace_, &ui::Workspace::unpin);
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
  on(a.reload, [this] { workspace_.reload(); });
  on(a.open_example, [this] { openExample(); });
  on(a.close_window, [this] { close(); });
  on(a.export_setpoints, [this] { exportSetpoints(); });
  on(a.export_picture, [this] { exportPicture(Picture::contour); });
  on(a.export_plots, [this] { exportPicture(Picture::plots); });
  on(a.export_window, [this] { exportPicture(Picture::window); });
  on(a.export_report, [this] { exportReport(); });
  on(a.open_machine, [this] { askMachine(); });
  on(a.save_machine, [this] { saveMachine(false); });
  on(a.save_machine_as, [this] { saveMachine(true); });
  on(a.default_machine, [this] {
    machine_ = {};
    workspace_.tuning().replace(tr("Default limits"), default_setup());
    showTitle();
  });
  auto& undo = workspace_.tuning().undoStack();
  on(a.undo, [&undo] { undo.undo(); });
  on(a.redo, [&undo] { undo.redo(); });
  connect(&undo, &QUndoStack::canUndoChanged, a.undo, &QAction::setEnabled);
  connect(&undo, &QUndoStack::canRedoChanged, a.redo, &QAction::setEnabled);
  a.undo->setEnabled(false);
  a.redo->setEnabled(false);
  on(a.find, [this] { nc_->openFindBar(); });
  on(a.edit_line, [this] { nc_->view().editCurrentLine(); });
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
  on(a.what_if, [this] {
    docks_["limitsDock"]->show();
    docks_["limitsDock"]->raise();
    what_if_->compute();
  });
  on(a.fit, [this] { contour_->fit(), profile_->fit(); });
  on(a.view_xy, [this] { contour_->setView(ui::View::xy); });
  on(a.view_xz, [this] { contour_->setView(ui::View::xz); });
  on(a.view_yz, [this] { contour_->setView(ui::View::yz); });
  on(a.view_iso, [this] { contour_->setView(ui::View::iso); });
  on(a.dark, [this](bool dark) { setDark(dark); });
  on(a.touch, [this](bool touch) { setTouch(touch); });
  on(a.inch, [this](bool inch) { setInch(inch); });
  on(a.english, [this] { setLanguage("en"); });
  on(a.chinese, [this] { setLanguage("zh_CN"); });
  on(a.reset_layout, [this] { restoreState(first_layout_); });
  on(a.show_keys, [this] { showKeys(); });
  on(a.about, [this] { showAbout(); });
}

void MainWindow::openProgram(const QString& path) { workspace_.openFile(path); }

void MainWindow::openExample() {
  QFile file(kExample);
  if (!file.open(QIODevice::ReadOnly)) return;
  workspace_.openText(file.readAll(), "butterfly.ngc");
}

void MainWindow::openLast() {
  if (QFileInfo::exists(preferences_.last_machine)) openMachine(preferences_.last_machine);
  if (QFileInfo::exists(preferences_.last_program)) return openProgram(preferences_.last_program);
  openExample();
}

void MainWindow::showDocument() {
  const auto& document = workspace_.document();
  nc_->view().setDocument(document);
  nc_->setHintVisible(document->path.isEmpty());
  tuning_->setRotaryVisible(uses_rotary(document->reading->moves));
  if (!document->path.isEmpty()) {
    preferences_.last_program = QFileInfo(document->path).absoluteFilePath();
    studio::remember(preferences_.recent_programs, preferences_.last_program);
  } else {
    preferences_.last_program.clear();
  }
  next_problem_ = next_slow_ = 0;
  transport_->setMessage({});
  showTitle();
  emit openedOrFailed();
}

void MainWindow::showPlan() {
  const ui::Planned& plan = workspace_.plan();
  nc_->view().setColourMap(contour_->colourMap());
  const auto speed = static_cast<std::size_t>(ui::ColourBy::speed);
  nc_->view().setTimeline(plan.timeline, plan ? plan.scene->range[speed].high : 0);
  contour_->setScene(plan.scene);
  profile_->setSeries(plan.series);
  profile_->setErrorTrace(plan.proof ? plan.proof->scene->trace : nullptr);
  results_->setPlans(plan, workspace_.pinned());
  what_if_->setTimeline(plan.timeline);
  loss_->setTimeline(plan.timeline);
  sweep_->setTimeline(plan.timeline);
  if (plan) {
    tuning_->setBlockCount(plan.timeline->outcome()->summary.blocks);
    const auto& corner = plan.timeline->outcome()->job->options.corner;
    const bool rounds = corner.rule == CornerRule::blend || corner.rule == CornerRule::smooth;
    contour_->setTolerance(rounds ? corner.tolerance : 0);
  }
  actions_->pin->setEnabled(static_cast<bool>(plan));
  showPinned();
  showCursor(workspace_.cursorTime());
}

void MainWindow::showPinned() {
  const ui::Planned& pinned = workspace_.pinned();
  contour_->setGhost(pinned.scene);
  profile_->setGhost(pinned.series);
  results_->setPlans(workspace_.plan(), pinned);
  actions_->unpin->setEnabled(static_cast<bool>(pinned));
  actions_->swap->setEnabled(static_cast<bool>(pinned));
}

void MainWindow::showProblems() {
  const auto& all = workspace_.problems();
  nc_->view().setProblems(all);
  problems_->setProblems(all);
  const auto first_error =
      std::find_if(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
  const bool has_errors = first_error != all.end();
  if (has_errors && !had_errors_) docks_["problemsDock"]->raise();
  if (!has_errors && had_errors_) docks_["resultsDock"]->raise();
  had_errors_ = has_errors;
  const QString count = all.empty() ? QString() : QString(" %1").arg(all.size());
  docks_["problemsDock"]->setWindowTitle(tr("Problems") + count);
}

void MainWindow::showCursor(double time) {
  const auto& timeline = workspace_.timeline();
  if (!timeline) {
    transport_->setInstant(std::nullopt);
    contour_->setCursorTime(std::nullopt);
    profile_->setCursorTime(std::nullopt);
    return;
  }
  const ui::Instant instant = timeline->at(time);
  transport_->setInstant(instant);
  contour_->setCursorTime(time);
  profile_->setCursorTime(time);
  if (instant.line > 0) {
    contour_->setHighlightedLine(instant.line);
    if (following_) nc_->view().setCurrentLine(static_cast<int>(instant.line));
  }
}

void MainWindow::showTitle() {
  const auto& document = workspace_.document();
  setWindowTitle(document ? document->name : QString());
  const bool edited = !workspace_.tuning().undoStack().isClean();
  const QString name = machine_.name.isEmpty() ? tr("default limits") : machine_.name;
  machine_button_->setText(tr("Machine: %1").arg(name + (edited ? "*" : "")));
  actions_->save_machine->setEnabled(edited || machine_.path.isEmpty());
}

void MainWindow::showFailure(const Error& error, const QString& path) {
  if (error.kind == ErrorKind::cancelled) return;
  Diagnostics problems = workspace_.problems();
  Diagnostic failure{Severity::error, error.code, error.message, error.remedy, error.where, {}};
  failure.where.line = 0;  // of another file than the one shown
  failure.message = QFileInfo(path).fileName().toStdString() + ": " + error.message;
  problems.insert(problems.begin(), failure);
  problems_->setProblems(problems);
  docks_["problemsDock"]->setWindowTitle(tr("Problems") + QString(" %1").arg(problems.size()));
  docks_["problemsDock"]->show();
  docks_["problemsDock"]->raise();
  transport_->setMessage(QString::fromStdString(failure.message));
  emit openedOrFailed();
}

void MainWindow::setDark(bool dark) {
  preferences_.dark = dark;
  actions_->dark->setChecked(dark);
  applyAppearance();
}

void MainWindow::setTouch(bool touch) {
  preferences_.touch = touch;
  actions_->touch->setChecked(touch);
  applyAppearance();
}

void MainWindow::applyAppearance() {
  theme_ = preferences_.dark ? ui::dark_theme() : ui::light_theme();
  ui::apply_theme(*qApp, theme_, preferences_.touch);
  actions_->setTheme(theme_);
  for (auto* button : {machine_button_, export_button_}) {
    button->setIcon(ui::icon(button == machine_button_ ? "machine" : "export", theme_));
  }
  nc_->view().setTheme(theme_);
  contour_->setTheme(theme_);
  profile_->setTheme(theme_);
  results_->setTheme(theme_);
  what_if_->setTheme(theme_);
  sweep_->setTheme(theme_);
  problems_->setTheme(theme_);
  single_move_->setTheme(theme_);
  stepper_->setTheme(theme_);
  transport_->setTheme(theme_);
  constexpr int kRow = 22, kTouchRow = 48;
  for (auto* table : findChildren<QTableView*>()) {
    table->verticalHeader()->setDefaultSectionSize(preferences_.touch ? kTouchRow : kRow);
  }
}

void MainWindow::setInch(bool inch) {
  preferences_.inch = inch;
  actions_->inch->setChecked(inch);
  const auto unit = inch ? ui::LengthUnit::inch : ui::LengthUnit::mm;
  contour_->setUnit(unit);
  profile_->setUnit(unit);
  tuning_->setLengthUnit(unit);
  results_->setLengthUnit(unit);
  loss_->setLengthUnit(unit);
  transport_->setLengthUnit(unit);
  unit_button_->setText(inch ? "in" : "mm");
}

void MainWindow::setLanguage(const QString& language) {
  const bool chinese = language.startsWith("zh");
  preferences_.language = chinese ? "zh_CN" : "en";
  (chinese ? actions_->chinese : actions_->english)->setChecked(true);
  QCoreApplication::removeTranslator(&translator_);
  QCoreApplication::removeTranslator(&qt_translator_);
  if (chinese) {
    if (qt_translator_.load("qtbase_zh_CN", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
      QCoreApplication::installTranslator(&qt_translator_);
    }
    if (translator_.load(":/translations/toolpace_zh_CN.qm")) QCoreApplication::installTranslator(&translator_);
  }
  retranslate();
}

void MainWindow::retranslate() {
  actions_->retranslate();
  const auto title = [this](const char* dock, const QString& text) {
    docks_[dock]->setWindowTitle(text);
    if (const auto found = titles_.find(dock); found != titles_.end()) found->second->setTitle(text);
  };
  title("programDock", tr("NC program"));
  title("plotsDock", tr("Motion along the path"));
  title("tuningDock", tr("Tuning"));
  title("resultsDock", tr("Result"));
  title("limitsDock", tr("Limits"));
  title("lossDock", tr("Lines"));
  title("sweepDock", tr("Depth"));
  title("singleMoveDock", tr("Single move"));
  title("stepperDock", tr("Stepper pulses"));
  const std::pair<QMenu*, QString> menus[] = {{file_menu_, tr("&File")},       {edit_menu_, tr("&Edit")},
                                              {plan_menu_, tr("&Plan")},       {view_menu_, tr("&View")},
                                              {help_menu_, tr("&Help")},       {recent_menu_, tr("Open re&cent")},
                                              {machine_menu_, tr("&Machine")}, {export_menu_, tr("&Export")},
                                              {panels_menu_, tr("&Panels")},   {language_menu_, tr("&Language")}};
  for (const auto& [menu, text] : menus) menu->setTitle(text);
  export_button_->setText(tr("Export"));
  export_button_->setToolTip(tr("Save setpoints and pictures"));
  machine_button_->setToolTip(tr("Machine file: limits and defaults"));
  machine_button_->setAccessibleName(tr("Machine"));
  unit_button_->setToolTip(tr("Switch between millimetres and inches"));
  unit_button_->setAccessibleName(unit_button_->toolTip());
  tool_bar_->setWindowTitle(tr("Tools"));
  showProblems();
  showTitle();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (remember_) {
    preferences_.geometry = saveGeometry();
    preferences_.layout = saveState();
    save_preferences(preferences_);
  }
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.constFirst().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = event->mimeData()->urls().constFirst().toLocalFile();
  event->acceptProposedAction();
  if (path.endsWith(".toml", Qt::CaseInsensitive)) {
    openMachine(path);
  } else {
    openProgram(path);
  }
}

// Keys without modifiers are shortcuts of the window, but a control that has the focus and uses the key comes first.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QMainWindow::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool arrows = key->key() == Qt::Key_Left || key->key() == Qt::Key_Right || key->key() == Qt::Key_Home ||
                      key->key() == Qt::Key_End;
  const bool space = key->key() == Qt::Key_Space;
  const bool letters = key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z;
  const auto is = [watched](auto* type) { return qobject_cast<decltype(type)>(watched) != nullptr; };
  const bool used = (is(static_cast<QSlider*>(nullptr)) && arrows) ||
                    (is(static_cast<QAbstractButton*>(nullptr)) && space) ||
                    (is(static_cast<QComboBox*>(nullptr)) && (space || letters)) ||
                    (is(static_cast<QAbstractItemView*>(nullptr)) && (arrows || letters || space)) ||
                    (watched == &nc_->view() && (key->key() == Qt::Key_Home || key->key() == Qt::Key_End));
  if (used && key->modifiers() == Qt::NoModifier) {
    event->accept();
    return true;
  }
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace toolpace::studio
