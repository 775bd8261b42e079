#include "models/tuning_model.h"

#include <QUndoCommand>

namespace toolpace::ui {

class TuningCommand : public QUndoCommand {
 public:
  TuningCommand(TuningModel& model, const QString& title, QString key, int gesture, Tuning before, Tuning after)
      : QUndoCommand(title),
        model_(model),
        key_(std::move(key)),
        gesture_(gesture),
        before_(std::move(before)),
        after_(std::move(after)) {}

  void undo() override { model_.apply(before_); }
  void redo() override { model_.apply(after_); }
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const TuningCommand&>(*next);
    if (gesture_ == 0 || other.gesture_ != gesture_ || other.key_ != key_) return false;
    after_ = other.after_;
    return true;
  }

 private:
  TuningModel& model_;
  QString key_;
  int gesture_;  // 0 = stands for itself
  Tuning before_, after_;
};

TuningModel::TuningModel(QObject* parent) : QObject(parent) {}

void TuningModel::edit(const QString& title, const QString& key, const std::function<void(Tuning&)>& change) {
  Tuning after = value_;
  change(after);
  undo_stack_.push(new TuningCommand(*this, title, key, in_gesture_ ? gesture_ : 0, value_, after));
}

void TuningModel::beginGesture() {
  if (in_gesture_) return;
  in_gesture_ = true;
  ++gesture_;
}

void TuningModel::endGesture() { in_gesture_ = false; }

void TuningModel::replace(const QString& title, const Tuning& tuning) {
  undo_stack_.push(new TuningCommand(*this, title, {}, 0, value_, tuning));
}

void TuningModel::reset(const Tuning& tuning) {
  undo_stack_.clear();
  apply(tuning);
}

void TuningModel::apply(const Tuning& tuning) {
  value_ = tuning;
  emit changed();
}

}  // namespace toolpace::ui
