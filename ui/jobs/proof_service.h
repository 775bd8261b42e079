#pragma once
/// Proves a plan's setpoints and simulates the drives, in a worker, once the plan has come to rest.

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "jobs/background.h"
#include "preview/contour_scene.h"
#include "preview/tube_trace.h"
#include "toolpace/servo/servo_simulation.h"
#include "toolpace/verify/report.h"

namespace toolpace::ui {

/// What an independent look at the setpoints found.
struct Proof {
  std::shared_ptr<const Outcome> outcome;
  VerifyReport report;                        ///< of the setpoints, written to a file and read back
  ServoSummary servo;                         ///< of the machine's drives
  double bound = 0;                           ///< no plan of the job is faster [s]
  std::shared_ptr<const ContourScene> scene;  ///< the preview with the contour errors in it, along the same geometry
  std::shared_ptr<const TubeTrace> tube;      ///< null for plans that stay on the programmed path
};

/// A plan of at most this many setpoints is proven without being asked; longer ones would keep a core busy for long.
inline constexpr std::size_t kProvenUnasked = 2'000'000;

class ProofService : public QObject {
  Q_OBJECT

 public:
  explicit ProofService(QObject* parent = nullptr);

  /// Starts a moment later, so that a drag is not slowed down; replaces what was asked before. Null = nothing.
  void request(std::shared_ptr<const ContourScene> scene);
  bool isRunning() const { return worker_.isBusy() || delay_.isActive(); }

 signals:
  void proven(std::shared_ptr<const toolpace::ui::Proof> proof);
  void failed(const toolpace::Error& error);
  void finished();

 private:
  void start();

  Background worker_;
  QTimer delay_;
  std::shared_ptr<const ContourScene> wanted_;
};

/// Broken checks as problems, each with its line.
Diagnostics problems_of(const VerifyReport& report);

}  // namespace toolpace::ui
