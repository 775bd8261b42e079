#pragma once
/// Machine and plan options under edit.

#include <QObject>
#include <QUndoStack>
#include <functional>

#include "toolpace/machine/setup.h"

namespace toolpace::ui {

using Tuning = Setup;

/// The one place where parameters change. Every edit is an undo step; edits of one key between beginGesture and
/// endGesture (a slider drag, a wheel turn) are one step together.
class TuningModel : public QObject {
  Q_OBJECT

 public:
  explicit TuningModel(QObject* parent = nullptr);

  const Tuning& value() const { return value_; }
  QUndoStack& undoStack() { return undo_stack_; }

  /// Applies `change` as an undo step called `title`.
  void edit(const QString& title, const QString& key, const std::function<void(Tuning&)>& change);
  void beginGesture();
  void endGesture();

  /// Takes over a whole new set, such as a machine that was opened, as one step.
  void replace(const QString& title, const Tuning& tuning);
  /// Starts afresh, without undo.
  void reset(const Tuning& tuning);

 signals:
  void changed();

 private:
  friend class TuningCommand;
  void apply(const Tuning& tuning);

  Tuning value_ = default_setup();
  QUndoStack undo_stack_;
  int gesture_ = 0;  // number of the running gesture
  bool in_gesture_ = false;
};

}  // namespace toolpace::ui
