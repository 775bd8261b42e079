#include "theme/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr int kSide = 20;  // logical pixels

// The files are drawn in currentColor, which Qt's renderer paints black.
QPixmap drawn(QByteArray svg, const QColor& colour, int scale) {
  svg.replace("currentColor", colour.name().toLatin1());
  QPixmap pixmap(kSide * scale, kSide * scale);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  QSvgRenderer(svg).render(&painter);
  painter.end();
  pixmap.setDevicePixelRatio(scale);
  return pixmap;
}

}  // namespace

QIcon icon(const QString& name, const Theme& tokens) {
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray svg = file.readAll();
  QIcon result;
  for (int scale : {1, 2, 3}) {
    result.addPixmap(drawn(svg, tokens.text, scale), QIcon::Normal, QIcon::Off);
    result.addPixmap(drawn(svg, tokens.accent, scale), QIcon::Normal, QIcon::On);
    result.addPixmap(drawn(svg, mixed(tokens.secondary, tokens.window, 0.5), scale), QIcon::Disabled, QIcon::Off);
  }
  return result;
}

}  // namespace toolpace::ui
