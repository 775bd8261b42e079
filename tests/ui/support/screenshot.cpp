#include "support/screenshot.h"

#include <QApplication>
#include <QDir>
#include <QSet>

#include "places.h"
#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr int kQuickly = 85;  // least compression but none: a smaller file takes longer than drawing what is in it

}  // namespace

QImage screenshot(QWidget& widget, const QString& name) {
  QApplication::processEvents();
  const QImage image = widget.grab().toImage();
  const QDir folder(QString::fromStdString((test::source_dir() / "build/screenshots").string()));
  folder.mkpath(".");
  image.save(folder.filePath(name + ".png"), "PNG", kQuickly);
  return image;
}

void wear(const Theme& theme) { apply_theme(*qApp, theme, false); }

int colours_in(const QImage& image) {
  QSet<QRgb> colours;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
  }
  return static_cast<int>(colours.size());
}

}  // namespace toolpace::ui
