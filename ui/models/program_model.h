#pragma once
/// The program under edit: its text, where it is kept, and whether that holds what the text says.

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "models/edit_state.h"
#include "models/program_text.h"

namespace toolpace::ui {

/// The one place where the text of a program changes. Every edit is an undo step that remembers the lines it changed, not
/// the text. What was read from a text (Document) comes later, from a worker.
class ProgramModel : public QObject {
  Q_OBJECT

 public:
  /// @param undo_stack  takes the edits as steps, in one order with what else is edited
  explicit ProgramModel(QUndoStack& undo_stack, QObject* parent = nullptr);

  const QString& path() const { return path_; }  ///< empty: a text without a file, such as the built-in example
  const QString& name() const { return name_; }
  const ProgramText& text() const { return text_; }
  quint64 state() const { return state_.now; }  ///< number of this text; another text has another one
  bool isModified() const { return !state_.is_saved(); }

  /// Puts another program in place of this one. Steps of the undo stack that edit this one's text empty the stack.
  void open(const QString& path, const QString& name, const ProgramText& text);
  /// Takes the text that the file has now. An undo step where there are other edits to undo, so that they can come back.
  void takeFile(const ProgramText& text);

  void replaceLine(qsizetype number, const QString& text);
  void insertLineAfter(qsizetype number);  ///< an empty one; its first replacement is one step with it
  void removeLines(qsizetype first, qsizetype count);

  /// The file at `path` now holds the text that had the number `state`.
  void setSaved(const QString& path, quint64 state);
  /// The file holds something else than this text ever was.
  void forgetSaved();

 signals:
  void edited(qsizetype line);  ///< done, undone or redone at this line
  void modifiedChanged(bool modified);
  void renamed();

 private:
  friend class LineCommand;
  friend class TextCommand;
  bool hasSteps() const;
  bool has(qsizetype first, qsizetype count) const;
  void setStates(quint64 now, quint64 saved);

  QUndoStack& undo_stack_;
  QString path_, name_;
  ProgramText text_;
  EditState state_;
};

}  // namespace toolpace::ui
