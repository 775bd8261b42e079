#pragma once
/// What is open in the window: the program, how it is tuned, its plan, the controller that it runs on, a plan beside it, and the
/// cursor.

#include <QObject>
#include <QUndoStack>
#include <memory>
#include <optional>

#include "jobs/controller_service.h"
#include "jobs/file_watcher.h"
#include "jobs/planner_service.h"
#include "jobs/playback.h"
#include "jobs/proof_service.h"
#include "jobs/reader_service.h"
#include "jobs/refiner.h"
#include "jobs/save_service.h"
#include "jobs/tune_service.h"
#include "models/controller_model.h"
#include "models/program_model.h"
#include "models/tuning_model.h"

namespace toolpace::ui {

/// Widgets show what it holds and tell it what people want; it reads and plans in workers.
class Workspace : public QObject {
  Q_OBJECT

 public:
  /// Edits that are not in the file, and the file is to be read again: because somebody asked for it, or because it was
  /// changed outside.
  enum class Conflict { none, reload, changed_outside };

  explicit Workspace(QObject* parent = nullptr);

  QUndoStack& undoStack() { return undo_stack_; }
  TuningModel& tuning() { return tuning_; }
  ProgramModel& program() { return program_; }
  ControllerModel& controller() { return controller_model_; }
  Playback& playback() { return playback_; }
  FileWatcher& watcher() { return watcher_; }                                    ///< of the program's file
  const std::shared_ptr<const Document>& document() const { return document_; }  ///< as last read
  const Planned& plan() const { return plan_; }                                  ///< plan A; empty before the first one
  /// Plan B: the one pinned, else what the controller does; empty = none.
  const Planned& pinned() const;
  const ControllerView& controllerView() const { return controller_view_; }
  /// How blocks come to whatever controller is chosen.
  void setSupply(const PredictOptions& supply);
  const std::shared_ptr<const Timeline>& timeline() const { return plan_.timeline; }
  const Diagnostics& problems() const { return problems_; }  ///< of reading and of planning
  double cursorTime() const { return cursor_; }
  bool isStale() const { return stale_; }  ///< the plan shown is not yet the one of the present text and parameters
  bool isBusy() const {
    return reader_.isBusy() || planner_.isBusy() || controller_.isBusy() || isRefining() || isSaving();
  }
  bool isSaving() const { return saver_.isBusy(); }
  /// The plan shown is a quick one; a better one is on its way.
  bool isRefining() const { return refiner_.state() == Refiner::State::running; }
  Refiner::State refinement() const { return refiner_.state(); }
  bool isComparing() const { return setpoints_.isRunning(); }  ///< plans setpoints on the controller's limits
  bool isProving() const { return proof_service_.isRunning(); }
  ProofService::State proofState() const { return proof_service_.state(); }
  void checkNow();      ///< proves the plan shown, however long it takes
  void stopChecking();  ///< leaves it without a proof
  /// The job as it stands; null without a program.
  std::shared_ptr<const Job> job() const;

  void openFile(const QString& path);
  void openText(const QByteArray& text, const QString& name);
  /// How programs are read; the one that is open is read again at once.
  void setReadOptions(const ReadOptions& options);
  /// With the kinematics of the machine, which programs about the tool's tip are read by.
  ReadOptions readOptions() const;
  /// Reads the file again, or the text where there is no file; with edits, asks first (conflict).
  void reload();
  Conflict conflict() const { return conflict_; }
  void takeFile();  ///< ends a conflict for the file; undo brings the edits back
  void keepMine();  ///< ends a conflict for the edits
  /// Writes the program in a worker and makes it the program's file; saved or saveFailed follows. Not while isSaving().
  void save(const QString& path);
  /// False when the program's file holds something that was never shown here.
  bool isFileKnown() const;
  void cancel();
  void setShown(ColourBy by) { planner_.setShown(by); }  ///< what the preview is coloured by
  /// Axes whose curves the plots show; axesReady() follows where a worker has to make them.
  void setShownAxes(const ShownAxes& axes);

  void pin();    ///< the present plan becomes B
  void unpin();  ///< the pinned plan goes, else the controller
  void swap();   ///< A takes B's parameters and B keeps A's plan

  void setCursorTime(double time);
  void setCursorLine(std::uint32_t line);
  void stepLine(int direction);
  void togglePlay();

 signals:
  void documentChanged(bool another);  ///< read; another program than before, or the same one anew
  void textChanged(qsizetype line);    ///< edited at this line; what is read from it comes later
  void editsWanted();  ///< the file is about to be read again: what is being typed belongs into the text
  void conflictChanged(toolpace::ui::Workspace::Conflict conflict);
  void saved(const QString& path);
  void saveFailed(const toolpace::Error& error, const QString& path);
  void planChanged();
  void pinnedChanged();
  void proofChanged();
  void proofStateChanged(toolpace::ui::ProofService::State state);
  void axesReady();
  void problemsChanged();
  void cursorChanged(double time);
  void staleChanged(bool stale);
  void refinementChanged(toolpace::ui::Refiner::State state);
  void busyChanged(bool busy);
  void progressed(double fraction);
  void openFailed(const toolpace::Error& error, const QString& path);
  void controllerChanged();  ///< which one, its settings, or what was found

 private:
  // workspace_program.cpp
  void connectProgram();
  void readText();
  void giveUpOpening();
  void takeDocument(std::shared_ptr<const Document> document, std::optional<FileStamp> stamp);
  bool takeText(const Document& document, std::optional<FileStamp> stamp);
  void takeSaved(const QString& path, quint64 state, std::optional<FileStamp> stamp);
  void takeOutsideChange();
  void setConflict(Conflict conflict);
  // workspace.cpp
  void followMachine();
  void replan();
  void show(const Planned& plan);
  void takeRefined(const Planned& plan);
  void takePlan(const Planned& plan, quint64 generation);
  void takeFailure(const Error& error, quint64 generation);
  void takeProof(std::shared_ptr<const Proof> proof);
  void collectProblems(const Diagnostics& of_plan);
  void showProblems();
  void addProblem(const Error& error);
  void setStale(bool stale);
  void makeAxes();
  // workspace_controller.cpp
  void connectController();
  void takeSettings();
  void runOnController();
  void forgetController();
  void takeDriven(const std::shared_ptr<const Controlled>& found, quint64 generation);
  void takeUndriven(const Error& error, quint64 generation);
  Diagnostics controllerProblems() const;

  QUndoStack undo_stack_;
  TuningModel tuning_{undo_stack_};
  ProgramModel program_{undo_stack_};
  ControllerModel controller_model_{undo_stack_};
  ReaderService reader_;
  SaveService saver_;
  PlannerService planner_;
  ControllerService controller_;
  TuneService setpoints_;
  ReadOptions read_options_;  ///< without what the machine tells
  Refiner refiner_;
  ProofService proof_service_;
  FileWatcher watcher_;
  Playback playback_;
  Background axis_worker_;
  ShownAxes shown_axes_ = {};
  std::shared_ptr<const Document> document_;
  quint64 read_state_ = 0;          // of the text that the document was read from
  std::optional<FileStamp> known_;  // the program's file as it was read, written, or passed over
  bool saving_this_program_ = false;
  bool opening_ = false;                            // wins over all that happens to the program that is to go
  bool text_waits_ = false, change_waits_ = false;  // to be read should the opening fail
  Conflict conflict_ = Conflict::none;
  Planned plan_, pinned_;
  ControllerView controller_view_;
  quint64 oldest_run_ = 0, latest_run_ = 0;  // of the controller; what is older is of another program
  Diagnostics problems_, plan_problems_;
  double cursor_ = 0;
  bool stale_ = false;
  bool axes_failed_ = false;  // not tried again for the same plan
};

}  // namespace toolpace::ui
