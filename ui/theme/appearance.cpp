#include "theme/appearance.h"

#include <QApplication>
#include <QPalette>

#include "theme/style_sheet.h"

namespace toolpace::ui {
namespace {

QPalette palette_of(const Theme& t) {
  QPalette p;
  const auto ground = [&p](QPalette::ColorRole role, const QColor& colour) { p.setColor(role, colour); };
  ground(QPalette::Window, t.window);
  ground(QPalette::WindowText, t.text);
  ground(QPalette::Base, t.surface);
  ground(QPalette::AlternateBase, mixed(t.surface, t.window, 0.6));
  ground(QPalette::Text, t.text);
  ground(QPalette::Button, t.surface);
  ground(QPalette::ButtonText, t.text);
  ground(QPalette::BrightText, t.error);
  ground(QPalette::Highlight, t.accent);
  ground(QPalette::HighlightedText, t.dark ? t.window : t.surface);
  ground(QPalette::ToolTipBase, t.surface);
  ground(QPalette::ToolTipText, t.text);
  ground(QPalette::PlaceholderText, t.secondary);
  ground(QPalette::Link, t.accent);
  ground(QPalette::Light, t.line);
  ground(QPalette::Midlight, t.line);
  ground(QPalette::Mid, t.line);
  ground(QPalette::Dark, t.line);
  ground(QPalette::Shadow, t.line);
  const QColor faint = mixed(t.secondary, t.window, 0.35);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, faint);
  }
  return p;
}

}  // namespace

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto blend = [share](float from, float to) { return static_cast<float>(from + (to - from) * share); };
  return QColor::fromRgbF(blend(a.redF(), b.redF()), blend(a.greenF(), b.greenF()), blend(a.blueF(), b.blueF()));
}

QFont monospace_font(qreal points) {
  QFont font;
  font.setFamilies({"DejaVu Sans Mono", "WenQuanYi Micro Hei Mono", "monospace"});
  font.setStyleHint(QFont::Monospace);
  font.setPointSizeF(points);
  return font;
}

// Each of the three goes through all widgets that there are, so what is as it should be is left alone.
void apply_theme(QApplication& application, const Theme& tokens, bool touch) {
  constexpr char kStyle[] = "Fusion", kStyled[] = "toolpaceStyle";
  if (application.property(kStyled) != QVariant(kStyle)) {
    QApplication::setStyle(kStyle);
    application.setProperty(kStyled, kStyle);
  }
  const QPalette palette = palette_of(tokens);
  if (QApplication::palette() != palette) QApplication::setPalette(palette);
  const QString sheet = style_sheet(tokens, touch);
  if (application.styleSheet() != sheet) application.setStyleSheet(sheet);
}

}  // namespace toolpace::ui
