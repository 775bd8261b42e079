/// The motion plots as pictures in files.

#include <QImage>
#include <QPainter>
#include <QPicture>

#include "plots/limit_ribbon.h"
#include "plots/profile_plot.h"
#include "plots/profile_view.h"
#include "theme/picture_file.h"

namespace toolpace::ui {

void ProfileView::paintRibbon(QPainter& painter) const {
  const auto [left, right] = plot_->edges();
  const auto [begin, end] = visibleRange();
  ribbon_->paintInto(painter, QRectF(left, plot_->height() + 4, right - left, 10), begin, end);
}

void ProfileView::paintAll(QPainter& painter) const {
  QPicture picture;
  QCPPainter into(&picture);
  into.setMode(QCPPainter::pmVectorized);
  plot_->toPainter(&into, plot_->width(), plot_->height());
  into.end();
  painter.drawPicture(0, 0, picture);
  paintRibbon(painter);
}

QImage ProfileView::picture(const QSize& size) const {
  constexpr double kScale = 2;
  QImage image(size * kScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(kScale);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.drawPixmap(0, 0, plot_->toPixmap(size.width(), plot_->height(), kScale));
  paintRibbon(painter);
  return image;
}

Result<void> ProfileView::exportPicture(const QString& file) const { return save_picture(file, drawing()); }

Drawing ProfileView::drawing() const {
  const QSize size(plot_->width(), plot_->height() + 18);
  const auto vectors = [this](QPainter& painter) { paintAll(painter); };
  return {size, [this, size] { return picture(size); }, vectors};
}

}  // namespace toolpace::ui
