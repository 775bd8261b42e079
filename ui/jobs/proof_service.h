#pragma once
/// Proves a plan's setpoints and simulates the drives, in a worker, once the plan has come to rest.

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "drawing/planned.h"
#include "jobs/background.h"

namespace toolpace::ui {

/// A plan of at most this many setpoints is proven without being asked; longer ones would keep a core busy for long.
inline constexpr std::size_t kProvenUnasked = 2'000'000;

class ProofService : public QObject {
  Q_OBJECT

 public:
  /// idle: nothing to prove, or proven; too_long: only where somebody asks; stopped: by a person or an error.
  enum class State { idle, running, too_long, stopped };
  Q_ENUM(State)

  explicit ProofService(QObject* parent = nullptr);

  /// Starts a moment later, so that a drag is not slowed down; replaces what was asked before. Null = nothing.
  void request(std::shared_ptr<const ContourScene> scene);
  /// Somebody asks: at once, and however long it takes.
  void requestNow(std::shared_ptr<const ContourScene> scene);
  /// A person has enough of waiting.
  void stop();
  State state() const { return state_; }
  bool isRunning() const { return worker_.isBusy() || delay_.isActive(); }

 signals:
  void proven(std::shared_ptr<const toolpace::ui::Proof> proof);
  void failed(const toolpace::Error& error);
  void finished();
  void stateChanged(toolpace::ui::ProofService::State state);

 private:
  void start();
  void setState(State state);
  void fail(const Error& error);

  Background worker_;
  QTimer delay_;
  std::shared_ptr<const ContourScene> wanted_;
  State state_ = State::idle;
  bool asked_ = false;  // by a person, for what is wanted
};

/// Broken checks as problems, each with its line.
Diagnostics problems_of(const VerifyReport& report);

}  // namespace toolpace::ui
