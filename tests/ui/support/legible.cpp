#include "support/legible.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <map>
#include <vector>

#include "drawing/colour_map.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastContrast = 4.5;

/// Of the pixel that stands out most against the colour that most pixels have.
double contrast_in(const QImage& image) {
  std::map<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  }
  const auto ground =
      std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) { return a.second < b.second; });
  double best = 1;
  for (const auto& [colour, count] : counts) best = std::max(best, contrast(colour, ground->first));
  return best;
}

QString text_of(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    return shows_text(*button) ? button->text() : QString();
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentText();
  const auto* field = qobject_cast<const QLineEdit*>(&widget);
  return field ? field->text() : QString();
}

}  // namespace

bool shows_text(const QAbstractButton& button) {
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  if (button.text().isEmpty() || !tool || tool->icon().isNull()) return !button.text().isEmpty();
  const bool follows =
      tool->toolButtonStyle() == Qt::ToolButtonFollowStyle && qobject_cast<QToolBar*>(tool->parentWidget());
  return tool->toolButtonStyle() != Qt::ToolButtonIconOnly && !follows;
}

QStringList illegible_in(QWidget& window) {
  QStringList troubles;
  const QImage picture = window.grab().toImage();
  const double ratio = picture.devicePixelRatio();
  std::map<QWidget*, std::vector<QWidget*>> siblings;
  for (auto* widget : window.findChildren<QWidget*>()) {
    const bool part = qobject_cast<QLabel*>(widget) || qobject_cast<QAbstractButton*>(widget) ||
                      qobject_cast<QLineEdit*>(widget) || qobject_cast<QComboBox*>(widget);
    if (!part || widget->window() != &window || widget->visibleRegion().isEmpty()) continue;
    if (qobject_cast<QLineEdit*>(widget->parentWidget()) || widget->parentWidget()->inherits("QTabBar")) continue;
    siblings[widget->parentWidget()].push_back(widget);
    const QString text = text_of(*widget);
    // A single thin character may have no pixel that is nothing but ink.
    if (text.size() < 2 || !widget->isEnabled()) continue;
    const QRect seen = widget->visibleRegion().boundingRect().translated(widget->mapTo(&window, QPoint()));
    const QRect pixels(seen.topLeft() * ratio, seen.size() * ratio);
    const double found = contrast_in(picture.copy(pixels));
    if (seen.height() >= widget->fontMetrics().height() && found < kLeastContrast)
      troubles << QString("contrast %1 of \"%2\"").arg(found).arg(text);
  }
  for (const auto& [parent, children] : siblings) {
    for (std::size_t i = 0; i < children.size(); ++i) {
      for (std::size_t k = i + 1; k < children.size(); ++k) {
        if (children[i]->geometry().intersects(children[k]->geometry()))
          troubles << children[i]->objectName() + " lies over " + children[k]->objectName();
      }
    }
  }
  return troubles;
}

}  // namespace toolpace::ui
