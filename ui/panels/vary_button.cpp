#include "panels/vary_button.h"

#include <QMenu>

#include "models/option_names.h"
#include "theme/control_name.h"

namespace toolpace::ui {

VaryButton::VaryButton(QWidget* parent) : QToolButton(parent) {
  setObjectName("tuneVary");
  setPopupMode(QToolButton::InstantPopup);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setFocusPolicy(Qt::StrongFocus);
  auto* menu = new QMenu(this);
  menu->setObjectName("tuneVaryMenu");
  for (const Knob knob : kAllKnobs) {
    const std::string_view name = knob_name(knob);
    auto* action = menu->addAction(QString());
    action->setObjectName("vary_" + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    action->setCheckable(true);
    action->setChecked(true);
    connect(action, &QAction::triggered, this, [this, action] { keepOne(action); });
    actions_[static_cast<std::size_t>(knob)] = action;
  }
  setMenu(menu);
  retranslate();
}

std::vector<Knob> VaryButton::chosen() const {
  std::vector<Knob> knobs;
  for (const Knob knob : kAllKnobs) {
    if (actions_[static_cast<std::size_t>(knob)]->isChecked()) knobs.push_back(knob);
  }
  return knobs;
}

void VaryButton::keepOne(QAction* action) {
  if (chosen().empty()) action->setChecked(true);
  showCount();
}

void VaryButton::showCount() {
  const std::size_t count = chosen().size();
  setText(count == kKnobCount ? tr("Vary: all") : tr("Vary: %1 of %2").arg(count).arg(kKnobCount));
  name_control(this, text(), tr("Which settings the search may change"));
}

void VaryButton::retranslate() {
  for (const Knob knob : kAllKnobs) actions_[static_cast<std::size_t>(knob)]->setText(knob_title(knob));
  showCount();
}

}  // namespace toolpace::ui
