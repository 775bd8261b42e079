#pragma once
/// The window: panels around preview and plots, wired to one workspace.

#include <QActionGroup>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QToolButton>
#include <QTranslator>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "actions.h"
#include "controller_file.h"
#include "drawing/plan_view.h"
#include "jobs/export_service.h"
#include "jobs/rewrite_service.h"
#include "jobs/trace_service.h"
#include "jobs/workspace.h"
#include "machine_file.h"
#include "models/problem_action.h"
#include "models/units.h"
#include "panels/welcome_bar.h"
#include "panels/wheel_guard.h"
#include "preferences.h"
#include "report.h"
#include "theme/theme.h"

class QDockWidget;
class QMenuBar;
class QPrinter;

namespace toolpace::ui {
class CausesPanel;
class CirclePanel;
class ChangeBar;
class ContourView;
class ControllerPanel;
class ControllerSection;
class DockTitle;
class DrivesPage;
class LossPanel;
class NcPanel;
class ProblemsPanel;
class ProfileView;
class ReadingPage;
class ResultsPanel;
class SingleMovePage;
class SpectrumPage;
class StepperPage;
class SweepPanel;
class TracePage;
class TransportBar;
class TunePage;
class TuningPanel;
}  // namespace toolpace::ui

namespace toolpace::studio {

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param remember  false: neither reads nor writes preferences (pictures, tests)
  explicit MainWindow(bool remember);
  ~MainWindow() override;

  ui::Workspace& workspace() { return workspace_; }
  Actions& actions() { return *actions_; }

  /// Asks first where the program that is open has changes that are not saved; so does openExample.
  void openProgram(const QString& path);
  void openExample();
  /// What was open when the window was last closed, else the example.
  void openLast();
  /// In a worker; the status line tells when it is done. The file becomes the program's.
  void storeProgramAs(const QString& path);
  /// Opens a machine file, or imports a LinuxCNC .ini or grbl's answer to $$, without asking about the one in use. False:
  /// the window says why.
  bool openMachine(const QString& path);
  bool storeMachineAs(const QString& path);
  /// The program runs on the controller whose settings these are: what it does is plan B. Does not ask about the one in use. False:
  /// the window says why.
  bool openController(const QString& settings);
  bool storeSettingsAs(const QString& path);
  /// In a worker; the status line tells when it is done. .pulses.csv = step pulses.
  void saveSetpoints(const QString& path);
  /// The same for a program that was written anew.
  void storeRewritten(std::shared_ptr<const ui::RewriteFound> found, const QString& path);
  /// Lays a trace beside the plan, in a worker, by these columns; again for each plan that follows.
  void openTrace(const QString& path, const TraceOptions& options);
  void setTimerFrequency(double hz);  ///< of the pulses' timer
  enum class Picture { contour, plots, window };
  bool saveReport(const QString& path);
  bool printTo(QPrinter& printer);  ///< report, preview and plots
  Result<void> savePicture(Picture picture, const QString& path);
  void setDark(bool dark);
  void setTouch(bool touch);
  void setInch(bool inch);
  void setPerMinute(bool per_minute);
  void setLanguage(const QString& language);  ///< "en" or "zh_CN"
  /// True when nothing is being read or planned any more.
  bool isSettled() const { return !workspace_.isBusy() && !exporter_.isBusy() && !tracer_.isBusy(); }
  /// And when no better picture of it is on its way.
  bool isAtRest() const;

 signals:
  void failed(const toolpace::Error& error);  ///< what was asked for could not be done; it is shown already
  void openedOrFailed();                      ///< the program that was asked for is shown, or its failure is

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  // main_window.cpp
  void showPlan();
  void showPlans();
  void showDocument(bool another);
  void showProblems();
  void showCursor(double time);
  void showTitle();
  void showDialect();
  void showState();
  void showFailure(const Error& error, const QString& path);
  void forgetFailure();
  // main_window_wiring.cpp
  void connectWorkspace();
  void connectPanels();
  void connectActions();
  // main_window_look.cpp
  void dressApplication();
  void applyAppearance();
  void showUnits();
  void retranslate();
  // main_window_layout.cpp
  void buildPanels();
  QDockWidget* addDock(const char* name, QWidget* content, Qt::DockWidgetArea area, bool titled);
  void addTool(const char* name, QWidget* page, const QSize& size);
  void arrange();
  void showWholeTuning();
  void resetLayout();
  void shareRoom();
  void giveShares();
  void rememberShares();
  QSize sharedSizes() const;
  // main_window_chrome.cpp
  void buildToolBar();
  void fitToolBar();
  void buildMenus();
  void fillRecent();
  void fillFormats();
  void fillMachines();
  // main_window_program.cpp
  void connectProgram();
  void askProgram();
  void saveProgram(bool ask, std::function<void()> then = {});
  void startSaving(const QString& path, std::function<void()> then);
  void takeSaved(const QString& path);
  bool mayLeaveProgram(std::function<void()> later);
  void rememberProgram();
  void showConflict(ui::Workspace::Conflict conflict);
  // main_window_machine.cpp
  void connectMachine();
  void askMachine();
  void importMachine();
  void chooseMachine(const QString& path);
  void chooseDefaultMachine();
  void takeMachine();
  bool mayLeaveMachine();
  // main_window_controller.cpp
  void buildController(QWidget* tuning_page);
  void connectController();
  void askController();
  void chooseController(const QString& settings);
  void leaveController();
  void takeController();
  void showControllerPage(bool shown);
  void showController();
  void fillControllers();
  void takeSetting(const QString& key, double value);
  bool mayLeaveController();
  bool saveSettings(bool ask);
  QString controllerName() const;
  // main_window_machine.cpp
  bool saveMachine(bool ask);
  QString askMachinePath(QString suggestion);
  QString machineName() const;
  static QString fileName(const QString& path);
  // main_window_exports.cpp
  void exportSetpoints(const QString& suffix);
  void exportPulses();
  void exportPicture(Picture picture);
  void exportReport();
  void askExport();
  void print();
  ReportParts reportParts(bool with_pictures);
  enum class Output { exported, program, machine, settings };
  Result<void> checkOutput(const QString& path, Output output);
  Result<void> mayWrite(const QString& path, Output output = Output::exported);
  QString askFile(const QString& title, const QString& suffix, const QStringList& filters);
  void askRewrite();
  void connectExporter();
  // main_window_trace.cpp
  void connectTrace();
  void askTrace();
  void chooseTrace(const QString& path);
  void closeTrace();
  void followTrace();
  void takeTrace(const std::shared_ptr<const ui::MeasuredTrace>& trace);
  bool isTrace(const QString& path) const;
  // main_window_help.cpp
  void goToProblem();
  void goToSlowest();
  void showHandbook();
  void showKeys();
  void showAbout();
  // main_window.cpp
  void holdAt(std::optional<double> time);  ///< [s]; nothing = no feed hold
  // main_window_menus.cpp
  void connectMenus();
  void showPlotMenu(const QPoint& at);
  void showProgramMenu(const QPoint& at);
  void showPreviewMenu(const QPoint& at);
  void showResultMenu(const QPoint& global);
  // main_window.cpp
  void showRotaryAxes();
  // main_window_help.cpp
  void remedy(ui::ProblemAction action);
  void tryOut(ui::WelcomeBar::Try what);
  void usePreset(std::size_t index);
  void showWelcome();

  bool remember_;
  Preferences preferences_;
  ui::Workspace workspace_;
  ui::ExportService exporter_;
  ui::RewriteService rewriter_;
  ui::TraceService tracer_;
  std::optional<Diagnostic>
      failure_;  ///< of the last file that could not be read or written, until something else is done
  MachineFile machine_{workspace_.tuning()};
  ControllerFile controller_file_{workspace_.controller()};
  Actions* actions_ = nullptr;
  ui::Theme theme_ = ui::light_theme();
  ui::WheelGuard wheel_guard_;
  QTranslator translator_, qt_translator_;

  ui::NcPanel* nc_ = nullptr;
  ui::ContourView* contour_ = nullptr;
  ui::ProfileView* profile_ = nullptr;
  ui::TuningPanel* tuning_ = nullptr;
  ui::ChangeBar* machine_bar_ = nullptr;
  ui::ControllerSection* settings_ = nullptr;
  ui::ChangeBar* settings_bar_ = nullptr;
  ui::ControllerPanel* controller_ = nullptr;
  ui::ResultsPanel* results_ = nullptr;
  ui::CausesPanel* causes_ = nullptr;
  ui::LossPanel* loss_ = nullptr;
  ui::SweepPanel* sweep_ = nullptr;
  ui::CirclePanel* circle_ = nullptr;
  ui::ProblemsPanel* problems_ = nullptr;
  ui::SingleMovePage* single_move_ = nullptr;
  ui::StepperPage* stepper_ = nullptr;
  ui::SpectrumPage* spectrum_ = nullptr;
  ui::TunePage* tune_ = nullptr;
  ui::TracePage* trace_ = nullptr;
  ui::DrivesPage* drives_ = nullptr;
  ui::ReadingPage* reading_ = nullptr;
  ui::WelcomeBar* welcome_ = nullptr;
  ui::TransportBar* transport_ = nullptr;
  std::vector<ui::PlanView*> plan_views_;  // all of them that show a plan
  QByteArray first_layout_;
  std::map<QString, QDockWidget*> docks_;
  std::map<QString, ui::DockTitle*> titles_;
  QToolBar* tool_bar_ = nullptr;
  QMenuBar* menu_bar_ = nullptr;  // in the tool bar: one row of chrome instead of two
  QMenu *file_menu_, *edit_menu_, *plan_menu_, *view_menu_, *help_menu_, *recent_menu_, *machine_menu_, *export_menu_,
      *setpoint_menu_, *runs_menu_, *panels_menu_, *preset_menu_, *language_menu_;
  QToolButton *open_button_ = nullptr, *machine_button_ = nullptr, *runs_button_ = nullptr, *unit_button_ = nullptr,
              *speed_unit_button_ = nullptr, *export_button_ = nullptr;
  std::optional<double> program_share_;  // of the window's width, as a person has it
  QSize at_press_;                       // of program and plots, when a mouse button went down
  double plot_share_ = 0.5;              // of the height between the bars
  bool limits_shown_ = true;             // before the controller's page took their place
  bool had_errors_ = false;
  bool following_ = true;  // the program scrolls along with the cursor
  std::size_t next_problem_ = 0, next_slow_ = 0;
  std::function<void()> after_saving_;  // what waits for the program to be saved
};

}  // namespace toolpace::studio
