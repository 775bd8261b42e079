#pragma once
/// Widgets by their names.

#include <QObject>

namespace toolpace::ui {

/// The descendant of this name; ends the test where there is none.
template <class T>
T& find(const QObject& within, const char* name) {
  auto* found = within.findChild<T*>(name);
  if (!found) qFatal("no %s", name);
  return *found;
}

}  // namespace toolpace::ui
