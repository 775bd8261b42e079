#pragma once
/// What a control is called.

#include <QString>
#include <QWidget>

namespace toolpace::ui {

/// Names it to screen readers, and says what it does to who rests the mouse on it: the tip, or else the name.
inline void name_control(QWidget* control, const QString& name, const QString& tip = {}) {
  control->setAccessibleName(name);
  control->setToolTip(tip.isEmpty() ? name : tip);
}

}  // namespace toolpace::ui
