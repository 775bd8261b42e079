#pragma once
/// A panel that may be a window of its own.

#include <QDockWidget>
#include <QPainter>

namespace toolpace::ui {

/// With a frame while it floats: a title bar of our own leaves it without the one of the system.
class Dock : public QDockWidget {
 public:
  using QDockWidget::QDockWidget;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QDockWidget::paintEvent(event);
    if (!isFloating()) return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
};

}  // namespace toolpace::ui
