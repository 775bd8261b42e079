#pragma once
/// What is open in the window: the program, how it is tuned, its plan, a pinned plan beside it, and the cursor.

#include <QObject>
#include <memory>

#include "jobs/file_watcher.h"
#include "jobs/planner_service.h"
#include "jobs/playback.h"
#include "jobs/proof_service.h"
#include "jobs/reader_service.h"
#include "jobs/refiner.h"
#include "models/tuning_model.h"

namespace toolpace::ui {

/// Widgets show what it holds and tell it what people want; it reads and plans in workers.
class Workspace : public QObject {
  Q_OBJECT

 public:
  explicit Workspace(QObject* parent = nullptr);

  TuningModel& tuning() { return tuning_; }
  Playback& playback() { return playback_; }
  const std::shared_ptr<const Document>& document() const { return document_; }
  const Planned& plan() const { return plan_; }      ///< plan A; empty before the first one
  const Planned& pinned() const { return pinned_; }  ///< plan B; empty = none
  const std::shared_ptr<const Timeline>& timeline() const { return plan_.timeline; }
  const Diagnostics& problems() const { return problems_; }  ///< of reading and of planning
  double cursorTime() const { return cursor_; }
  bool isStale() const { return stale_; }  ///< the plan shown is not yet the one of the present parameters
  bool isBusy() const { return reader_.isBusy() || planner_.isBusy() || isRefining(); }
  /// The plan shown is a quick one; a better one is on its way.
  bool isRefining() const { return refiner_.state() == Refiner::State::running; }
  Refiner::State refinement() const { return refiner_.state(); }
  bool isProving() const { return proof_service_.isRunning(); }
  /// The job as it stands; null without a program.
  std::shared_ptr<const Job> job() const;

  void openFile(const QString& path);
  void openText(const QByteArray& text, const QString& name);
  void reload();
  void editLine(int line, const QString& text);
  void cancel();
  void setShown(ColourBy by) { planner_.setShown(by); }  ///< what the preview is coloured by
  /// Axes whose curves the plots show; axesReady() follows where a worker has to make them.
  void setShownAxes(const ShownAxes& axes);

  void pin();  ///< the present plan becomes B
  void unpin();
  void swap();  ///< A takes B's parameters and B keeps A's plan

  void setCursorTime(double time);
  void setCursorLine(std::uint32_t line);
  void stepLine(int direction);
  void togglePlay();

 signals:
  void documentChanged();
  void planChanged();
  void pinnedChanged();
  void proofChanged();
  void axesReady();
  void problemsChanged();
  void cursorChanged(double time);
  void staleChanged(bool stale);
  void refinementChanged(toolpace::ui::Refiner::State state);
  void busyChanged(bool busy);
  void progressed(double fraction);
  void openFailed(const toolpace::Error& error, const QString& path);

 private:
  void replan();
  void takeDocument(std::shared_ptr<const Document> document);
  void show(const Planned& plan);
  void takeRefined(const Planned& plan);
  void takePlan(const Planned& plan, quint64 generation);
  void takeFailure(const Error& error, quint64 generation);
  void takeProof(std::shared_ptr<const Proof> proof);
  void collectProblems(const Diagnostics& of_plan);
  void setStale(bool stale);
  void makeAxes();

  TuningModel tuning_;
  ReaderService reader_;
  PlannerService planner_;
  Refiner refiner_;
  ProofService proof_service_;
  FileWatcher watcher_;
  Playback playback_;
  Background axis_worker_;
  ShownAxes shown_axes_ = {};
  std::shared_ptr<const Document> document_;
  Planned plan_, pinned_;
  Diagnostics problems_;
  double cursor_ = 0;
  bool stale_ = false;
};

}  // namespace toolpace::ui
