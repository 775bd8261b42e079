#include "theme/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr int kSide = 20;  // logical pixels

// The files are drawn in currentColor, which Qt's renderer paints black.
QPixmap draw(QByteArray svg, const QColor& colour, int scale) {
  svg.replace("currentColor", colour.name().toLatin1());
  QPixmap pixmap(kSide * scale, kSide * scale);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  QSvgRenderer(svg).render(&painter);
  painter.end();
  pixmap.setDevicePixelRatio(scale);
  return pixmap;
}

// The same icon is wanted by each window and after each change of the theme.
QPixmap drawn(const QString& name, const QByteArray& svg, const QColor& colour, int scale) {
  const QString key = QString("icon/%1/%2/%3").arg(name, colour.name()).arg(scale);
  QPixmap pixmap;
  if (!QPixmapCache::find(key, &pixmap)) QPixmapCache::insert(key, pixmap = draw(svg, colour, scale));
  return pixmap;
}

}  // namespace

QIcon icon(const QString& name, const Theme& tokens) {
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray svg = file.readAll();
  QIcon result;
  for (int scale : {1, 2, 3}) {
    result.addPixmap(drawn(name, svg, tokens.text, scale), QIcon::Normal, QIcon::Off);
    result.addPixmap(drawn(name, svg, tokens.accent, scale), QIcon::Normal, QIcon::On);
    result.addPixmap(drawn(name, svg, mixed(tokens.secondary, tokens.window, 0.5), scale), QIcon::Disabled, QIcon::Off);
  }
  return result;
}

}  // namespace toolpace::ui
