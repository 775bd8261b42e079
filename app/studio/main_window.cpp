#include "main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QLocale>
#include <QMimeData>
#include <QSlider>
#include <algorithm>

#include "jobs/regular_file.h"
#include "models/block_name.h"
#include "panels/causes_panel.h"
#include "panels/circle_panel.h"
#include "panels/controller_section.h"
#include "panels/dock_title.h"
#include "panels/drives_page.h"
#include "panels/loss_panel.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/reading_page.h"
#include "panels/results_panel.h"
#include "panels/spectrum_page.h"
#include "panels/sweep_panel.h"
#include "panels/transport_bar.h"
#include "panels/tune_page.h"
#include "panels/tuning_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "tab_order.h"
#include "toolpace/machine/read_machine.h"

namespace toolpace::studio {
namespace {

constexpr QSize kFirstSize = {1280, 800};

/// A list that is open: letters choose in it. Elsewhere they are the window's.
bool pops_up(const QObject* object) {
  const auto* widget = qobject_cast<const QWidget*>(object);
  return widget && widget->window()->windowType() == Qt::Popup;
}

/// Of machines: by the name, or, where that says nothing, by what stands in the file.
bool is_machine_file(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix == "toml" || suffix == "ini") return true;
  if (suffix != "txt" && suffix != "cfg" && suffix != "log" && !suffix.isEmpty()) return false;
  const auto text = ui::read_regular_file(path);
  return text && machine_format(path.toStdString(), text->bytes.toStdString()) != MachineFormat::toml;
}

}  // namespace

MainWindow::MainWindow(bool remember)
    : remember_(remember), preferences_(remember ? load_preferences() : Preferences{}), actions_(new Actions(this)) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  dressApplication();  // what is built from here on is dressed once, when it is shown
  buildPanels();
  buildMenus();
  buildToolBar();
  connectWorkspace();
  connectPanels();
  connectActions();
  connectMenus();
  connectExporter();
  qApp->installEventFilter(this);
  qApp->installEventFilter(&wheel_guard_);
  setLanguage(preferences_.language.isEmpty() ? QLocale::system().name() : preferences_.language);
  actions_->dark->setChecked(preferences_.dark);
  actions_->touch->setChecked(preferences_.touch);
  applyAppearance();
  showUnits();
  reading_->setOptions(preferences_.reading);
  workspace_.setReadOptions(preferences_.reading);
  workspace_.setSupply(preferences_.supply);
  if (const auto map = ui::colour_map_named(preferences_.colour_map)) contour_->setColourMap(*map);
  resize(kFirstSize);
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

bool MainWindow::isAtRest() const {
  return isSettled() && !workspace_.isComparing() && !contour_->canvas().isMoving() && !spectrum_->isBusy();
}

void MainWindow::showDocument(bool another) {
  const auto& document = workspace_.document();
  nc_->view().setDocument(document, another);
  if (another) contour_->setView(ui::View::xy);  // to begin with; its first picture may suit another one better
  nc_->setHintVisible(document->path.isEmpty());
  tuning_->setRotaryAxes(document->turned);
  reading_->setFolder(QFileInfo(document->path).absolutePath());
  showRotaryAxes();
  showWelcome();
  showWholeTuning();
  rememberProgram();
  next_problem_ = next_slow_ = 0;
  if (!document->edited_state) transport_->setMessage({});
  showTitle();
  emit openedOrFailed();
}

void MainWindow::showRotaryAxes() {
  const auto& document = workspace_.document();
  const std::array<bool, 3> turned = document ? document->turned : std::array<bool, 3>{};
  const auto rotary = ui::rotary_axes(workspace_.tuning().value().machine, turned);
  drives_->setRotaryAxes(rotary);
  spectrum_->setRotaryAxes(rotary);
  profile_->setRotaryAxes(rotary);
  transport_->setRotaryAxes(rotary);
}

void MainWindow::showPlan() {
  nc_->setColourMap(contour_->colourMap());
  showPlans();
  const bool has_plan = static_cast<bool>(workspace_.plan());
  actions_->pin->setEnabled(has_plan);
  actions_->hold->setEnabled(has_plan);
  actions_->no_hold->setEnabled(workspace_.tuning().value().options.hold_at.has_value());
  followTrace();
  showCursor(workspace_.cursorTime());
}

void MainWindow::showPlans() {
  for (ui::PlanView* view : plan_views_) view->showPlans(workspace_.plan(), workspace_.pinned());
  const bool has_pinned = static_cast<bool>(workspace_.pinned());
  actions_->unpin->setEnabled(has_pinned);
  actions_->swap->setEnabled(has_pinned);
}

void MainWindow::showProblems() {
  const auto& all = workspace_.problems();
  nc_->view().setProblems(all);
  Diagnostics shown = all;
  for (Diagnostic warning : machine_.warnings()) {
    warning.message = fileName(QString::fromStdString(warning.where.file)).toStdString() + ": " + warning.message;
    warning.where.line = 0;  // of another file than the one shown
    shown.push_back(std::move(warning));
  }
  if (failure_) shown.insert(shown.begin(), *failure_);
  problems_->setProblems(shown);
  const auto first_error =
      std::find_if(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
  const bool has_errors = first_error != all.end();
  if (has_errors && !had_errors_) docks_["problemsDock"]->raise();
  if (!has_errors && had_errors_) docks_["resultsDock"]->raise();
  had_errors_ = has_errors;
  const QString count = shown.empty() ? QString() : QString(" %1").arg(shown.size());
  docks_["problemsDock"]->setWindowTitle(tr("Problems") + count);
}

void MainWindow::forgetFailure() {
  if (!failure_) return;
  failure_.reset();
  showProblems();
}

void MainWindow::showCursor(double time) {
  const auto& timeline = workspace_.timeline();
  const std::optional<ui::Instant> instant = timeline ? std::optional(timeline->at(time)) : std::nullopt;
  const auto& document = workspace_.document();
  transport_->setBlockName(instant && document ? ui::block_name(*document, instant->line) : QString());
  for (ui::PlanView* view : plan_views_) view->showInstant(instant);
  if (instant && instant->line > 0 && following_) nc_->view().setCurrentLine(static_cast<int>(instant->line));
}

void MainWindow::showState() {
  using State = ui::Refiner::State;
  const State state = workspace_.refinement();
  ui::DockTitle& title = *titles_["tuningDock"];
  transport_->setTask(state == State::running ? tr("refining…") : tr("planning"));
  if (workspace_.isStale())
    return title.setBadge(tr("stale"), tr("The plan shown is not yet the one of these parameters"));
  if (state == State::running) {
    return title.setBadge(tr("refining…"),
                          tr("Shown is a quick plan; a faster motion inside the tolerance is computed"));
  }
  if (state == State::given_up) {
    return title.setBadge(tr("not refined"), tr("Shown is the quick plan; reload (F5) to refine it"));
  }
  title.setBadge({}, {});
}

void MainWindow::holdAt(std::optional<double> time) {
  if (!workspace_.timeline() || workspace_.tuning().value().options.hold_at == time) return;
  workspace_.tuning().edit(tr("Feed hold"), "hold", [time](ui::Tuning& t) { t.options.hold_at = time; });
}

void MainWindow::showTitle() {
  const auto& program = workspace_.program();
  setWindowTitle(program.name() + "[*]");
  setWindowModified(program.isModified());
  program.isModified() ? titles_["programDock"]->setBadge(tr("edited"), tr("Changes that are not saved"))
                       : showDialect();
  actions_->save_program->setEnabled(program.isModified() || program.path().isEmpty());
  machine_button_->setText(machineName() + (machine_.isModified() ? "*" : ""));
  actions_->save_machine->setEnabled(machine_.isModified() || machine_.path().isEmpty());
  const bool settings_edited = controller_file_.isModified();
  fitToolBar();
  settings_->setModified(settings_edited);
  actions_->save_settings->setEnabled(settings_edited);
  actions_->save_settings_as->setEnabled(!controller_file_.path().isEmpty());
}

/// In which dialect the program was read, and why in that one.
void MainWindow::showDialect() {
  const auto& document = workspace_.document();
  if (!document || document->path.isEmpty()) return titles_["programDock"]->setBadge({}, {});
  QStringList reasons;
  for (const std::string& reason : document->reading->dialect_reasons) reasons << QString::fromStdString(reason);
  const auto name = dialect_name(document->reading->dialect);
  titles_["programDock"]->setBadge(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())),
                                   tr("Dialect of the program") + (reasons.isEmpty() ? "" : "\n" + reasons.join("\n")),
                                   ui::DockTitle::Badge::note);
}

void MainWindow::showFailure(const Error& error, const QString& path) {
  if (error.kind == ErrorKind::cancelled) return;
  Diagnostic& failure = failure_.emplace();
  failure.code = error.code;
  failure.message = error.message;
  failure.remedy = error.remedy;
  failure.where = error.where;
  failure.where.line = 0;  // of another file than the one shown
  const std::string name = QFileInfo(path).fileName().toStdString();
  if (error.message.find(name) == std::string::npos) failure.message = name + ": " + error.message;
  showProblems();
  docks_["problemsDock"]->show();
  docks_["problemsDock"]->raise();
  transport_->setMessage(ui::message_text(failure.code, failure.message));
  emit failed(error);
  emit openedOrFailed();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLeaveProgram([this] { close(); }) || !mayLeaveMachine() || !mayLeaveController()) return event->ignore();
  if (remember_) {
    showControllerPage(false);  // the next start chooses none
    preferences_.geometry = saveGeometry();
    preferences_.layout = saveState();
    preferences_.reading = reading_->options();
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
  const bool is_machine = is_machine_file(path);
  const bool is_trace = !is_machine && workspace_.document() && isTrace(path);
  const auto open = [this, path, is_machine, is_trace] {
    if (is_trace) return chooseTrace(path);
    is_machine ? chooseMachine(path) : openProgram(path);
  };
  const bool asks = is_trace || (is_machine ? machine_.isModified() : workspace_.program().isModified());
  if (!asks) return open();
  QMetaObject::invokeMethod(this, open, Qt::QueuedConnection);  // whoever drags waits for the drop to be over
}

bool MainWindow::focusNextPrevChild(bool next) { return focus_next(*this, next); }

// Keys without modifiers are shortcuts of the window, but a control that has the focus and uses the key comes first.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == this && event->type() == QEvent::MouseButtonPress) at_press_ = sharedSizes();
  if (watched == this && event->type() == QEvent::MouseButtonRelease && at_press_ != sharedSizes()) rememberShares();
  if (event->type() != QEvent::ShortcutOverride) return QMainWindow::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool arrows = key->key() == Qt::Key_Left || key->key() == Qt::Key_Right || key->key() == Qt::Key_Home ||
                      key->key() == Qt::Key_End;
  const bool space = key->key() == Qt::Key_Space;
  const bool letters = key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z;
  const auto is = [watched](auto* type) { return qobject_cast<decltype(type)>(watched) != nullptr; };
  const bool used =
      (is(static_cast<QSlider*>(nullptr)) && arrows) || (is(static_cast<QAbstractButton*>(nullptr)) && space) ||
      (is(static_cast<QComboBox*>(nullptr)) && space) ||
      (is(static_cast<QAbstractItemView*>(nullptr)) && (arrows || space || (letters && pops_up(watched)))) ||
      (watched == &nc_->view() && (key->key() == Qt::Key_Home || key->key() == Qt::Key_End));
  if (used && key->modifiers() == Qt::NoModifier) {
    event->accept();
    return true;
  }
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace toolpace::studio
