#pragma once
/// Plans that take long (pipeline/job.h): a quick one is shown first, the optimised one when it is there.

#include <QObject>
#include <QTimer>
#include <memory>

#include "jobs/planner_service.h"

namespace toolpace::ui {

/// Plans the latest job that it was given, in a worker of its own, beside everything else that goes on.
class Refiner : public QObject {
  Q_OBJECT

 public:
  /// idle: nothing to refine, or refined; given_up: cancelled or failed, the quick plan stays.
  enum class State { idle, running, given_up };
  Q_ENUM(State)

  explicit Refiner(QObject* parent = nullptr);

  /// Starts a moment later, so that a drag is not slowed down.
  void request(std::shared_ptr<const Job> job);
  /// An edit: what runs is stopped and never arrives.
  void drop();
  /// A person has enough of waiting.
  void giveUp();
  State state() const { return state_; }
  void setShownAxes(const ShownAxes& axes) { planner_.setShownAxes(axes); }

 signals:
  void refined(const toolpace::ui::Planned& plan);
  void failed(const toolpace::Error& error);
  void progressed(double fraction);
  void stateChanged(toolpace::ui::Refiner::State state);

 private:
  void setState(State state);

  PlannerService planner_;
  QTimer delay_;
  std::shared_ptr<const Job> wanted_;
  State state_ = State::idle;
};

}  // namespace toolpace::ui
