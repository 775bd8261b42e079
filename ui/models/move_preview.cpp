#include "models/move_preview.h"

#include <QCoreApplication>
#include <limits>

namespace toolpace::ui {
namespace {

constexpr int kSamplesAPhase = 96;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

void append_samples(const Phase& phase, MovePreview& preview) {
  const int count = phase.acceleration == 0 && phase.rate == 0 ? 1 : kSamplesAPhase;
  for (int i = 0; i <= count; ++i) {
    const double local = phase.duration * i / count;
    const PhaseState state = evaluate(phase, local);
    preview.time.push_back(phase.begin + local);
    preview.speed.push_back(state.speed);
    preview.acceleration.push_back(state.acceleration);
    preview.jerk.push_back(state.jerk);
    preview.distance.push_back(state.distance);
  }
}

MovePhase::Kind kind_of(const Phase& phase) {
  const double change = evaluate(phase, phase.duration).speed - phase.speed;
  if (phase.acceleration == 0 && phase.rate == 0) return MovePhase::Kind::cruise;
  return change > 0 ? MovePhase::Kind::speeding_up : MovePhase::Kind::slowing_down;
}

}  // namespace

QString move_unit_text(MoveQuantity quantity, MoveUnits units) {
  const bool metric = units == MoveUnits::millimetres;
  const QString length = metric ? QString("mm") : QCoreApplication::translate("MoveUnits", "pulse");
  const QString time = metric ? QString("s") : QCoreApplication::translate("MoveUnits", "cycle");
  switch (quantity) {
    case MoveQuantity::length: return length;
    case MoveQuantity::time: return time;
    case MoveQuantity::speed: return length + "/" + time;
    case MoveQuantity::acceleration: return length + "/" + time + "²";
    case MoveQuantity::jerk: break;
  }
  return length + "/" + time + "³";
}

MovePreview preview_move(const SingleMove& move) {
  MovePreview preview;
  preview.move = move;
  for (const Phase& phase : move.phases) {
    preview.phases.push_back({phase.begin, phase.duration, kind_of(phase)});
    append_samples(phase, preview);
  }
  return preview;
}

Dynamics MoveForm::dynamics() const {
  const LawRow& row = law_row(law);
  if (row.uses_time) return {{kUnbounded, kUnbounded, t_acc}, {kUnbounded, kUnbounded, t_dec}};
  if (!row.bounds_jerk) return {{acceleration, kUnbounded, 0.0}, {deceleration, kUnbounded, 0.0}};
  return {{acceleration, jerk, 0.0}, {deceleration, jerk_deceleration, 0.0}};
}

const std::array<MovePreset, 4>& move_presets() {
  static const std::array<MovePreset, 4> presets = [] {
    MoveForm first;
    first.move = {4000, 100, 10, 20};
    MoveForm second = first;
    second.t_acc = 45;
    second.t_dec = 30;
    MoveForm curve;
    curve.law = LawKind::seven_phase;
    curve.units = MoveUnits::millimetres;
    curve.move = {20, 100, 0, 0};
    curve.jerk = curve.jerk_deceleration = 1e5;
    curve.t_acc = curve.t_dec = 0.05;
    MoveForm quintic = curve;
    quintic.law = LawKind::quintic;
    quintic.move = {5, 100, 20, 40};
    quintic.jerk = quintic.jerk_deceleration = 1e6;
    return std::array<MovePreset, 4>{
        {{"zheng-1", first}, {"zheng-2", second}, {"s-curve", curve}, {"quintic", quintic}}};
  }();
  return presets;
}

}  // namespace toolpace::ui
