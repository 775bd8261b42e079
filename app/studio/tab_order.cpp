#include "tab_order.h"

#include <QApplication>
#include <QDockWidget>
#include <QScrollArea>
#include <algorithm>

namespace toolpace::studio {
namespace {

struct Stop {
  QWidget* widget;
  const QWidget* panel;
  QRect place;  ///< in the window
};

QRect place_of(const QWidget& widget, const QMainWindow& window) {
  return {widget.mapTo(&window, QPoint(0, 0)), widget.size()};
}

/// The child of the window that it stands in: a dock, the middle, a bar.
const QWidget* panel_of(const QWidget* widget, const QMainWindow& window) {
  while (widget->parentWidget() && widget->parentWidget() != &window) widget = widget->parentWidget();
  return widget;
}

/// Panels behind another tab are visible to Qt, but stand beside the window. An area that scrolls leaves the focus to what is
/// in it.
bool takes_tab(const QWidget& widget, const QMainWindow& window) {
  if (qobject_cast<const QScrollArea*>(&widget) || widget.window() != &window || &widget == &window) return false;
  if (!panel_of(&widget, window)->geometry().intersects(window.rect())) return false;
  return (widget.focusPolicy() & Qt::TabFocus) == Qt::TabFocus && widget.isVisible() && widget.isEnabled() &&
         !widget.focusProxy();
}

/// Rows from top to bottom, each from left to right. What begins above the middle of a row's first stands in that row.
template <class T, class Place>
void sort_by_rows(std::vector<T>& list, const Place& place) {
  std::sort(list.begin(), list.end(), [&](const T& a, const T& b) {
    const QRect pa = place(a), pb = place(b);
    return pa.top() != pb.top() ? pa.top() < pb.top() : pa.left() < pb.left();
  });
  for (auto row = list.begin(); row != list.end();) {
    const int middle = place(*row).center().y();
    const auto end = std::find_if(row, list.end(), [&](const T& t) { return place(t).top() > middle; });
    std::sort(row, end, [&](const T& a, const T& b) { return place(a).left() < place(b).left(); });
    row = end;
  }
}

}  // namespace

std::vector<QWidget*> reading_order(const QMainWindow& window) {
  std::vector<Stop> stops;
  std::vector<const QWidget*> panels;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!takes_tab(*widget, window)) continue;
    stops.push_back({widget, panel_of(widget, window), place_of(*widget, window)});
    if (std::find(panels.begin(), panels.end(), stops.back().panel) == panels.end())
      panels.push_back(stops.back().panel);
  }
  // Panels are tall: they stand in one row where they begin at about the same height.
  std::sort(panels.begin(), panels.end(), [&](const QWidget* a, const QWidget* b) {
    constexpr int kSameRow = 16;
    const QPoint pa = a->pos(), pb = b->pos();
    const int row_a = pa.y() / kSameRow, row_b = pb.y() / kSameRow;
    return row_a != row_b ? row_a < row_b : pa.x() < pb.x();
  });
  std::vector<QWidget*> order;
  for (const QWidget* panel : panels) {
    std::vector<Stop> inside;
    std::copy_if(stops.begin(), stops.end(), std::back_inserter(inside),
                 [&](const Stop& s) { return s.panel == panel; });
    sort_by_rows(inside, [](const Stop& s) { return s.place; });
    for (const Stop& stop : inside) order.push_back(stop.widget);
  }
  return order;
}

bool focus_next(QMainWindow& window, bool next) {
  const auto order = reading_order(window);
  if (order.empty()) return false;
  const auto now = std::find(order.begin(), order.end(), QApplication::focusWidget());
  const auto count = static_cast<std::ptrdiff_t>(order.size());
  const std::ptrdiff_t at = now == order.end() ? (next ? -1 : 0) : now - order.begin();
  QWidget* to = order[static_cast<std::size_t>((at + (next ? 1 : -1) + count) % count)];
  to->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  for (QWidget* parent = to->parentWidget(); parent; parent = parent->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(parent)) area->ensureWidgetVisible(to);
  }
  return true;
}

}  // namespace toolpace::studio
