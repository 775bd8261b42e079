#include "theme/finish_drawing.h"

#include <QAbstractEventDispatcher>

namespace toolpace::ui {

void finish_drawing() {
  // A layout asks for another one, that for a picture, and a view for its rows at the next idle moment.
  auto& dispatcher = *QAbstractEventDispatcher::instance();
  while (dispatcher.processEvents(QEventLoop::AllEvents)) {
  }
}

}  // namespace toolpace::ui
