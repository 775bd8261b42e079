#include "jobs/proof_service.h"

#include <QTemporaryDir>

#include "jobs/setpoint_export.h"
#include "models/units.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::ui {
namespace {

constexpr int kDelayMs = 200;

Result<VerifyReport> verified(const Outcome& outcome, const Monitor& monitor) {
  QTemporaryDir folder;
  const QString file = folder.filePath("setpoints.npz");  // of all formats the quickest that keeps the lines
  if (auto written = write_setpoints(outcome, file, {}, monitor); !written) return tl::unexpected(written.error());
  return prove(file.toStdString(), outcome, monitor);
}

Eigen::Vector3f offset_of(const ServoTrace& trace, const Setpoints& commanded, std::size_t row, std::size_t in_chunk) {
  Eigen::Vector3f offset = Eigen::Vector3f::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (trace.actual[axis].empty()) continue;
    offset[static_cast<Eigen::Index>(axis)] =
        static_cast<float>(trace.actual[axis][row] - commanded.position[axis][in_chunk]);
  }
  return offset;
}

Result<void> simulate(const Outcome& outcome, ErrorTrace& errors, const Monitor& monitor) {
  auto simulation = ServoSimulation::create(outcome.job->machine.servo, outcome.job->machine.period);
  if (!simulation) return tl::unexpected(simulation.error());
  Sampler sampler = sampler_of(outcome);
  ServoTrace trace;
  Setpoints chunk;
  while (sampler.next(chunk)) {
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    const std::size_t before = errors.time.size();
    simulation->take(chunk, trace);
    for (std::size_t i = 0; i < chunk.size(); ++i) {
      errors.time.push_back(chunk.time(i));
      errors.offset.push_back(offset_of(trace, chunk, before + i, i));
      errors.commanded.emplace_back(static_cast<float>(chunk.position[0][i]), static_cast<float>(chunk.position[1][i]),
                                    static_cast<float>(chunk.position[2][i]));
    }
  }
  (void)simulation->finish(trace);
  errors.error.assign(trace.contour_error.begin(), trace.contour_error.end());
  return {};
}

Result<std::shared_ptr<const Proof>> proof_of(const ContourScene& scene, const Monitor& monitor) {
  const auto& outcome = scene.outcome;
  auto report = verified(*outcome, monitor);
  if (!report) return tl::unexpected(report.error());
  auto errors = std::make_shared<ErrorTrace>();
  if (auto done = simulate(*outcome, *errors, monitor); !done) return tl::unexpected(done.error());
  auto proof = std::make_shared<Proof>();
  proof->outcome = outcome;
  proof->report = std::move(*report);
  proof->contour = contour_errors(*outcome, *errors);
  proof->chord_error = chord_error(*outcome, monitor);
  auto bound = lower_bound(*outcome, {monitor.stop, {}});
  if (!bound) return tl::unexpected(bound.error());
  proof->bound = *bound;
  proof->vibration = make_vibration_trace(*outcome, {monitor.stop, {}});
  proof->tube = make_tube_trace(*outcome, monitor);
  proof->scene = make_contour_scene(outcome, errors, scene.geometry);
  return proof;
}

Quantity quantity_of(const Check& check) {
  Quantity quantity = Quantity::length;
  switch (check.kind) {
    case CheckKind::axis_speed:
    case CheckKind::path_speed:
    case CheckKind::speed_column: quantity = Quantity::speed; break;
    case CheckKind::axis_acceleration:
    case CheckKind::path_acceleration:
    case CheckKind::path_deceleration:
    case CheckKind::acceleration_column: quantity = Quantity::acceleration; break;
    case CheckKind::axis_jerk:
    case CheckKind::path_jerk:
    case CheckKind::jerk_column: quantity = Quantity::jerk; break;
    case CheckKind::time_step: quantity = Quantity::time; break;
    default: break;
  }
  return check.axis && is_rotary(*check.axis) ? rotary(quantity) : quantity;
}

}  // namespace

Diagnostics problems_of(const VerifyReport& report) {
  Diagnostics problems;
  for (const Check& check : report.checks) {
    if (!check.broken) continue;
    const std::string key = key_of(check.kind);
    const QString axis = check.axis ? QString(QLatin1Char(kAxisNames[*check.axis])) + " " : QString();
    const Quantity quantity = quantity_of(check);
    const QString text = axis + QString::fromStdString(key) + ": " + value_text(check.value, quantity, {}) + " > " +
                         value_text(check.limit, quantity, {});
    problems.push_back({Severity::error, "violation-" + key, text.toStdString(), {}, {{}, check.line, 0}, {}});
  }
  return problems;
}

ProofService::ProofService(QObject* parent) : QObject(parent) {
  delay_.setSingleShot(true);
  delay_.setInterval(kDelayMs);
  connect(&delay_, &QTimer::timeout, this, &ProofService::start);
  connect(&worker_, &Background::finished, this, [this] {
    if (wanted_ && !delay_.isActive()) start();
    if (isRunning()) return;
    if (state_ == State::running) setState(State::idle);
    emit finished();
  });
}

void ProofService::request(std::shared_ptr<const ContourScene> scene) {
  wanted_ = std::move(scene);
  asked_ = false;
  worker_.cancel();
  wanted_ ? delay_.start() : delay_.stop();
  setState(wanted_ ? State::running : State::idle);
}

void ProofService::requestNow(std::shared_ptr<const ContourScene> scene) {
  request(std::move(scene));
  asked_ = true;
  delay_.stop();
  start();
}

void ProofService::stop() {
  if (state_ != State::running) return;
  request(nullptr);
  setState(State::stopped);
}

void ProofService::setState(State state) {
  if (state == state_) return;
  state_ = state;
  emit stateChanged(state);
}

void ProofService::fail(const Error& error) {
  if (!wanted_) setState(State::stopped);
  emit failed(error);
}

void ProofService::start() {
  if (worker_.isBusy() || !wanted_) return;
  const double rows = wanted_->outcome->plan.cycle_time() / wanted_->outcome->job->machine.period;
  if (!asked_ && rows > static_cast<double>(kProvenUnasked)) {
    wanted_ = nullptr;
    setState(State::too_long);
    return emit finished();
  }
  const auto prove = [this, scene = std::exchange(wanted_, nullptr)](const Monitor& monitor) {
    auto proof = proof_of(*scene, monitor);
    return [this, proof = std::move(proof)] {
      if (proof) {
        emit proven(*proof);
      } else if (proof.error().kind != ErrorKind::cancelled) {
        fail(proof.error());
      }
    };
  };
  worker_.start(prove, [this](const Error& error) { fail(error); });
}

}  // namespace toolpace::ui
