#include "models/controller_model.h"

#include <QUndoCommand>

#include "toolpace/machine/edit_settings.h"

namespace toolpace::ui {
namespace {

ReadIncluded reader_of(const std::shared_ptr<const IncludedTexts>& texts) {
  return [texts](std::string_view name) {
    const auto at = texts ? texts->find(name) : IncludedTexts::const_iterator{};
    return texts && at != texts->end() ? at->second : std::vector<std::string>{};
  };
}

}  // namespace

Result<SharedControllerText> parse_controller_text(const QString& path, std::string text,
                                                   std::shared_ptr<const IncludedTexts> included) {
  auto settings = parse_controller_settings(text, path.toStdString(), {}, reader_of(included));
  if (!settings) return tl::unexpected(settings.error());
  return std::make_shared<const ControllerText>(
      ControllerText{path, std::move(text), std::move(included), std::move(*settings)});
}

Result<SharedControllerText> with_setting(const ControllerText& before, const std::string& key, double value) {
  auto text = edit_controller_setting(before.text, before.path.toStdString(), before.settings.controller, key, value,
                                      reader_of(before.included));
  if (!text) return tl::unexpected(text.error());
  return parse_controller_text(before.path, std::move(*text), before.included);
}

Result<SharedControllerText> carried_over(const ControllerText& base, const ControllerText& mine,
                                          const ControllerText& origin) {
  SharedControllerText result = std::make_shared<const ControllerText>(base);
  if (base.settings.controller != mine.settings.controller) return result;
  ControllerSettings mine_copy = mine.settings, origin_copy = origin.settings;
  const auto wanted = parameters(mine_copy), had = parameters(origin_copy);
  for (std::size_t i = 0; i < wanted.size() && i < had.size(); ++i) {
    if (wanted[i].key != had[i].key || *wanted[i].value == *had[i].value) continue;
    auto next = with_setting(*result, wanted[i].key, *wanted[i].value / wanted[i].size);
    if (!next) return next;
    result = std::move(*next);
  }
  return result;
}

class ControllerCommand : public QUndoCommand {
 public:
  ControllerCommand(ControllerModel& model, const QString& title, std::string key, int gesture,
                    SharedControllerText after)
      : QUndoCommand(title),
        model_(model),
        key_(std::move(key)),
        gesture_(gesture),
        before_(model.text_),
        after_(std::move(after)) {}

  void undo() override { model_.apply(before_); }
  void redo() override { model_.apply(after_); }
  int id() const override { return kId; }

  bool mergeWith(const QUndoCommand* next) override {
    const auto& other = static_cast<const ControllerCommand&>(*next);
    if (gesture_ == 0 || other.gesture_ != gesture_ || other.key_ != key_) return false;
    after_ = other.after_;
    return true;
  }

 private:
  static constexpr int kId = 3;  // none of the other commands of the stack

  ControllerModel& model_;
  std::string key_;
  int gesture_;  // 0 = stands for itself
  SharedControllerText before_, after_;
};

ControllerModel::ControllerModel(QUndoStack& undo_stack, QObject* parent) : QObject(parent), undo_stack_(undo_stack) {}

Result<void> ControllerModel::edit(const QString& title, const std::string& key, double value) {
  if (!text_) return {};
  auto next = with_setting(*text_, key, value);
  if (!next) return tl::unexpected(next.error());
  if ((*next)->text != text_->text) {
    undo_stack_.push(new ControllerCommand(*this, title, key, in_gesture_ ? gesture_ : 0, std::move(*next)));
  }
  return {};
}

void ControllerModel::beginGesture() {
  if (in_gesture_) return;
  in_gesture_ = true;
  ++gesture_;
}

void ControllerModel::replace(const QString& title, SharedControllerText text) {
  if (text == text_) return;
  undo_stack_.push(new ControllerCommand(*this, title, {}, 0, std::move(text)));
}

void ControllerModel::apply(const SharedControllerText& text) {
  text_ = text;
  emit changed();
}

}  // namespace toolpace::ui
