#include "panels/wheel_guard.h"

#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace toolpace::ui {

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  const bool guarded = event->type() == QEvent::Wheel || event->type() == QEvent::Polish;
  if (!guarded || !(qobject_cast<QComboBox*>(watched) || qobject_cast<QSlider*>(watched))) return false;
  auto* const control = static_cast<QWidget*>(watched);
  if (event->type() == QEvent::Polish) {
    if (control->focusPolicy() == Qt::WheelFocus) control->setFocusPolicy(Qt::StrongFocus);
    return false;
  }
  if (control->hasFocus()) return false;
  event->ignore();  // to whatever it lies in
  return true;
}

}  // namespace toolpace::ui
