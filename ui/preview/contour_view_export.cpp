/// The contour preview as a picture in a file.

#include <QImage>
#include <QPainter>

#include "preview/contour_legend.h"
#include "preview/contour_view.h"
#include "theme/line_key.h"
#include "theme/picture_file.h"

namespace toolpace::ui {
namespace {

constexpr int kTitlePadding = 12;  // px

}  // namespace

/// "part.ngc · 12.345 s"
QString ContourView::title() const {
  const auto& scene = canvas_->scene();
  if (!scene || !scene->outcome || !scene->outcome->job) return {};
  const Outcome& outcome = *scene->outcome;
  return QString::fromStdString(outcome.job->program_name) + " · " + duration_text(outcome.plan.cycle_time());
}

/// Title, picture with axes and scale, legend: one below the other.
void ContourView::paintAll(QPainter& painter, const QImage& picture) const {
  const QSize size = canvas_->size();
  const int high = titleHeight();
  painter.fillRect(QRect(0, 0, size.width(), high + size.height() + legend_->height()), canvas_->theme().surface);
  painter.setFont(font());
  painter.setPen(canvas_->theme().text);
  const int key = key_->samples().empty() ? 0 : key_->sizeHint().width() + kTitlePadding;
  const int room = size.width() - 2 * kTitlePadding - key;
  painter.drawText(QRect(kTitlePadding, 0, room, high), Qt::AlignVCenter,
                   fontMetrics().elidedText(title(), Qt::ElideMiddle, room));
  key_->paintInto(painter, QRectF(size.width() - key, 0, key, high));
  painter.save();
  painter.translate(0, high);
  picture.isNull() ? canvas_->paintVectors(painter, QSizeF(size)) : painter.drawImage(QRect({0, 0}, size), picture);
  painter.setRenderHint(QPainter::Antialiasing);
  canvas_->drawAxes(painter);
  canvas_->drawScaleBar(painter);
  painter.restore();
  legend_->render(&painter, QPoint(0, high + size.height()));
}

int ContourView::titleHeight() const { return fontMetrics().height() + kTitlePadding; }

Result<void> ContourView::exportPicture(const QString& file) const { return save_picture(file, drawing()); }

Drawing ContourView::drawing() const {
  constexpr double kScale = 2;
  const QSize size = canvas_->size(), whole(size.width(), titleHeight() + size.height() + legend_->height());
  const auto pixels = [this, size, whole] {
    QImage image(whole * kScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kScale);
    QPainter painter(&image);
    paintAll(painter, canvas_->render(size, kScale));
    return image;
  };
  return {whole, pixels, [this](QPainter& painter) { paintAll(painter, {}); }};
}

}  // namespace toolpace::ui
