#pragma once
/// Plans in a worker.

#include <QObject>
#include <memory>
#include <vector>

#include "drawing/planned.h"
#include "jobs/background.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// Finishes the plan that runs, then takes the latest job: a drag shows every plan that gets done, never starves.
class PlannerService : public QObject {
  Q_OBJECT

 public:
  explicit PlannerService(QObject* parent = nullptr);

  /// @return the job's generation; results of older generations are marked stale by isLatest
  quint64 submit(std::shared_ptr<const Job> job);
  /// Drops what waits and stops what runs.
  void cancel();
  bool isBusy() const { return worker_.isBusy(); }
  bool isLatest(quint64 generation) const { return generation == latest_; }
  /// What the preview shows, so that the worker makes its colours ready.
  void setShown(ColourBy by) { shown_ = by; }
  /// And the curves of these axes.
  void setShownAxes(const ShownAxes& axes) { axes_ = axes; }

 signals:
  void planned(const toolpace::ui::Planned& plan, quint64 generation);
  void failed(const toolpace::Error& error, quint64 generation);
  void progressed(double fraction);
  void busyChanged(bool busy);

 private:
  void start(std::shared_ptr<const Job> job, quint64 generation);

  /// Of the last plan, for the next to take over what an edit leaves as it was.
  struct Last {
    std::shared_ptr<const Outcome> outcome;
    std::shared_ptr<const SceneGeometry> geometry;
  };

  Background worker_;
  std::shared_ptr<const Job> pending_;
  Last last_;
  ColourBy shown_ = ColourBy::speed;
  ShownAxes axes_ = {};
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
