#pragma once
/// Machine and plan options under edit.

#include <QObject>
#include <QUndoStack>
#include <array>
#include <functional>

#include "models/edit_state.h"
#include "toolpace/machine/setup.h"

namespace toolpace::ui {

using Tuning = Setup;

/// Which of A, B, C a machine says anything of, or a program turns.
std::array<bool, 3> rotary_axes(const Machine& machine, const std::array<bool, 3>& turned);

/// The one place where parameters change. Every edit is an undo step; edits of one key between beginGesture and
/// endGesture (a slider drag, a wheel turn) are one step together.
class TuningModel : public QObject {
  Q_OBJECT

 public:
  /// @param undo_stack  takes the edits as steps, in one order with what else is edited
  explicit TuningModel(QUndoStack& undo_stack, QObject* parent = nullptr);

  const Tuning& value() const { return value_; }
  QUndoStack& undoStack() { return undo_stack_; }
  /// True when the value is the one of the last setClean, whatever was done and undone since.
  bool isClean() const { return state_.is_saved(); }
  void setClean();

  /// Applies `change` as an undo step called `title`.
  void edit(const QString& title, const QString& key, const std::function<void(Tuning&)>& change);
  void beginGesture();
  void endGesture();

  /// Takes over a whole new set, such as a machine that was opened, as one step.
  void replace(const QString& title, const Tuning& tuning);
  /// Starts afresh, without undo of anything.
  void reset(const Tuning& tuning);

 signals:
  void changed();
  void cleanChanged(bool clean);

 private:
  friend class TuningCommand;
  void apply(const Tuning& tuning, quint64 state);

  QUndoStack& undo_stack_;
  Tuning value_ = default_setup();
  EditState state_;
  int gesture_ = 0;  // number of the running gesture
  bool in_gesture_ = false;
};

}  // namespace toolpace::ui
