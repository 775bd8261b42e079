#include "models/tuning_model.h"

#include <QUndoCommand>

namespace toolpace::ui {

class TuningCommand : public QUndoCommand {
 public:
  TuningCommand(TuningModel& model, const QString& title, QString key, int gesture, Tuning after)
      : QUndoCommand(title),
        model_(model),
        key_(std::move(key)),
        gesture_(gesture),
        before_(model.value_),
        after_(std::move(after)),
        state_before_(model.state_.now),
        state_after_(model.state_.fresh()) {}

  void undo() override { model_.apply(before_, state_before_); }
  void redo() override { model_.apply(after_, state_after_); }
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const TuningCommand&>(*next);
    if (gesture_ == 0 || other.gesture_ != gesture_ || other.key_ != key_) return false;
    after_ = other.after_;
    state_after_ = other.state_after_;
    return true;
  }

 private:
  TuningModel& model_;
  QString key_;
  int gesture_;  // 0 = stands for itself
  Tuning before_, after_;
  quint64 state_before_, state_after_;
};

std::array<bool, 3> rotary_axes(const Machine& machine, const std::array<bool, 3>& turned) {
  std::array<bool, 3> there = turned;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const AxisLimits &limits = machine.axes[3 + i], nothing;
    there[i] = there[i] || limits.speed != nothing.speed || limits.acceleration != nothing.acceleration ||
               limits.jerk != nothing.jerk || limits.travel_min != nothing.travel_min ||
               limits.travel_max != nothing.travel_max || limits.steps_per_unit != nothing.steps_per_unit;
  }
  return there;
}

TuningModel::TuningModel(QUndoStack& undo_stack, QObject* parent) : QObject(parent), undo_stack_(undo_stack) {}

void TuningModel::edit(const QString& title, const QString& key, const std::function<void(Tuning&)>& change) {
  Tuning after = value_;
  change(after);
  undo_stack_.push(new TuningCommand(*this, title, key, in_gesture_ ? gesture_ : 0, std::move(after)));
}

void TuningModel::beginGesture() {
  if (in_gesture_) return;
  in_gesture_ = true;
  ++gesture_;
}

void TuningModel::endGesture() { in_gesture_ = false; }

void TuningModel::replace(const QString& title, const Tuning& tuning) {
  undo_stack_.push(new TuningCommand(*this, title, {}, 0, tuning));
}

void TuningModel::reset(const Tuning& tuning) {
  undo_stack_.clear();
  apply(tuning, state_.fresh());
}

void TuningModel::setClean() {
  const bool was_clean = isClean();
  state_.saved = state_.now;
  if (!was_clean) emit cleanChanged(true);
}

void TuningModel::apply(const Tuning& tuning, quint64 state) {
  const bool was_clean = isClean();
  value_ = tuning;
  state_.now = state;
  emit changed();
  if (isClean() != was_clean) emit cleanChanged(isClean());
}

}  // namespace toolpace::ui
