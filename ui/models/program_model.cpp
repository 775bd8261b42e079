#include "models/program_model.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <utility>

namespace toolpace::ui {

/// A step in the text of a program, between two states of it.
class ProgramCommand : public QUndoCommand {
 protected:
  ProgramCommand(const QString& title, quint64 before, quint64 after)
      : QUndoCommand(title), before_(before), after_(after) {}

  quint64 before_, after_;
};

class LineCommand : public ProgramCommand {
 public:
  /// @param opened  line that was added for somebody to write into; 0 = none
  LineCommand(ProgramModel& model, const QString& title, ProgramText::Splice splice, qsizetype line, qsizetype opened)
      : ProgramCommand(title, model.state_.now, model.state_.fresh()),
        model_(model),
        splice_(std::move(splice)),
        line_(line),
        opened_(opened) {}

  void undo() override { toggle(before_); }
  void redo() override { toggle(after_); }
  int id() const override { return 2; }

  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const LineCommand&>(*next);
    if (opened_ == 0 || other.opened_ != 0 || other.line_ != opened_ || other.splice_.count != 1) return false;
    opened_ = 0;
    after_ = other.after_;
    return true;  // what takes the added line back takes back what was written into it
  }

 private:
  void toggle(quint64 state) {
    splice_ = model_.text_.apply(splice_);
    model_.setStates(state, model_.state_.saved);
    emit model_.edited(line_);
  }

  ProgramModel& model_;
  ProgramText::Splice splice_;  // what the next undo or redo does
  qsizetype line_, opened_;
};

class TextCommand : public ProgramCommand {
 public:
  TextCommand(ProgramModel& model, const QString& title, ProgramText other)
      : ProgramCommand(title, model.state_.now, model.state_.fresh()), model_(model), other_(std::move(other)) {}

  void undo() override { toggle(before_, true); }
  void redo() override { toggle(after_, std::exchange(shown_, true)); }

 private:
  void toggle(quint64 state, bool tell) {
    std::swap(model_.text_, other_);
    model_.setStates(state, model_.state_.saved);
    if (tell) emit model_.edited(1);
  }

  ProgramModel& model_;
  ProgramText other_;   // the text before, or after
  bool shown_ = false;  // who brings a text from a file shows it
};

ProgramModel::ProgramModel(QUndoStack& undo_stack, QObject* parent) : QObject(parent), undo_stack_(undo_stack) {}

bool ProgramModel::hasSteps() const {
  for (int i = 0; i < undo_stack_.count(); ++i) {
    if (dynamic_cast<const ProgramCommand*>(undo_stack_.command(i))) return true;
  }
  return false;
}

void ProgramModel::setStates(quint64 now, quint64 saved) {
  const bool was_modified = isModified();
  state_.now = now;
  state_.saved = saved;
  if (isModified() != was_modified) emit modifiedChanged(isModified());
}

void ProgramModel::open(const QString& path, const QString& name, const ProgramText& text) {
  if (hasSteps()) undo_stack_.clear();
  path_ = path;
  name_ = name;
  text_ = text;
  const quint64 state = state_.fresh();
  setStates(state, state);
  emit renamed();
}

void ProgramModel::takeFile(const ProgramText& text) {
  if (hasSteps()) {
    undo_stack_.push(new TextCommand(*this, tr("Reload"), text));
    return setStates(state_.now, state_.now);
  }
  text_ = text;
  const quint64 state = state_.fresh();
  setStates(state, state);
}

bool ProgramModel::has(qsizetype first, qsizetype count) const {
  return first >= 1 && count >= 1 && first + count - 1 <= text_.line_count();
}

void ProgramModel::replaceLine(qsizetype number, const QString& text) {
  if (!has(number, 1) || text_.line(number) == text) return;
  undo_stack_.push(new LineCommand(*this, tr("Edit line %1").arg(number), text_.replacing(number, text), number, 0));
}

void ProgramModel::insertLineAfter(qsizetype number) {
  if (!has(number, 1)) return;
  const QString title = tr("Insert line %1").arg(number + 1);
  undo_stack_.push(new LineCommand(*this, title, text_.inserting_after(number), number + 1, number + 1));
}

void ProgramModel::removeLines(qsizetype first, qsizetype count) {
  if (!has(first, count)) return;
  const QString title =
      count == 1 ? tr("Delete line %1").arg(first) : tr("Delete lines %1 to %2").arg(first).arg(first + count - 1);
  undo_stack_.push(new LineCommand(*this, title, text_.removing(first, count), first, 0));
}

void ProgramModel::setSaved(const QString& path, quint64 state) {
  const bool elsewhere = path != path_;
  path_ = path;
  name_ = QFileInfo(path).fileName();
  setStates(state_.now, state);
  if (elsewhere) emit renamed();
}

void ProgramModel::forgetSaved() { setStates(state_.now, state_.fresh()); }

}  // namespace toolpace::ui
