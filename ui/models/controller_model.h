#pragma once
/// The settings of the controller that the program runs on, under edit in the controller's own text.

#include <QObject>
#include <QUndoStack>
#include <map>
#include <memory>

#include "toolpace/base/result.h"
#include "toolpace/machine/controller_settings.h"

namespace toolpace::ui {

/// The texts that a settings file includes, by the name or pattern under which it does.
using IncludedTexts = std::map<std::string, std::vector<std::string>, std::less<>>;

/// Settings with the text that says them. Immutable; an edit makes new ones.
struct ControllerText {
  QString path;      ///< file that they came from
  std::string text;  ///< as it would be saved
  std::shared_ptr<const IncludedTexts> included;
  ControllerSettings settings;  ///< what the text says
};
using SharedControllerText = std::shared_ptr<const ControllerText>;

/// Errors: those of parse_controller_settings().
Result<SharedControllerText> parse_controller_text(const QString& path, std::string text,
                                                   std::shared_ptr<const IncludedTexts> included);
/// With one parameter changed, in its own unit. What follows from it in the controller follows here. Errors: those of
/// edit_controller_setting().
Result<SharedControllerText> with_setting(const ControllerText& before, const std::string& key, double value);
/// `base` with all that `mine` has otherwise than `origin`. Errors: those of edit_controller_setting().
Result<SharedControllerText> carried_over(const ControllerText& base, const ControllerText& mine,
                                          const ControllerText& origin);

/// The one place where settings of a controller change; every change is an undo step, be it another controller. No text: the
/// program runs on Toolpace's own plan.
class ControllerModel : public QObject {
  Q_OBJECT

 public:
  /// @param undo_stack  takes the edits as steps, in one order with what else is edited
  explicit ControllerModel(QUndoStack& undo_stack, QObject* parent = nullptr);

  const SharedControllerText& text() const { return text_; }  ///< null: Toolpace's own plan

  /// Says no and changes nothing where the text cannot hold the value; else an undo step, and edits of one key between
  /// beginGesture and endGesture are one together.
  Result<void> edit(const QString& title, const std::string& key, double value);
  void beginGesture();
  void endGesture() { in_gesture_ = false; }
  /// Another text, or none, as an undo step.
  void replace(const QString& title, SharedControllerText text);

 signals:
  void changed();

 private:
  friend class ControllerCommand;
  void apply(const SharedControllerText& text);

  QUndoStack& undo_stack_;
  SharedControllerText text_;
  int gesture_ = 0;  // number of the running gesture
  bool in_gesture_ = false;
};

}  // namespace toolpace::ui
