#pragma once
/// What a text is, which decides its colour.

#include <QStyle>
#include <QWidget>

namespace toolpace::ui {

/// "secondary", "warning", "error", "good": a role of the style sheet, which is looked up again.
inline void set_role(QWidget* widget, const QString& role) {
  if (widget->property("role").toString() == role) return;
  widget->setProperty("role", role);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
  widget->update();
}

}  // namespace toolpace::ui
