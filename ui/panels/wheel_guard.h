#pragma once
/// A wheel that turns over a panel scrolls the panel.

#include <QObject>

namespace toolpace::ui {

/// Installed on the application: lists and sliders take the wheel only while they have the focus, and do not take the focus
/// from the wheel. Scroll bars are left alone.
class WheelGuard : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace toolpace::ui
