#include "theme/picture_file.h"

#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>

namespace toolpace::ui {
namespace {

constexpr int kDotsPerInch = 96;
constexpr double kPointsPerPixel = 72.0 / kDotsPerInch;

}  // namespace

bool save_picture(const QString& file, const QSize& size, const std::function<void(QPainter&)>& vectors,
                  const std::function<QImage()>& pixels) {
  const QString kind = QFileInfo(file).suffix().toLower();
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return false;
  if (kind == "svg") {
    QSvgGenerator svg;
    svg.setOutputDevice(&out);
    svg.setSize(size);
    svg.setViewBox(QRect({0, 0}, size));
    QPainter painter(&svg);
    vectors(painter);
  } else if (kind == "pdf") {
    QPdfWriter pdf(&out);
    pdf.setResolution(kDotsPerInch);
    pdf.setPageSize(QPageSize(QSizeF(size) * kPointsPerPixel, QPageSize::Point));
    pdf.setPageMargins({});
    QPainter painter(&pdf);
    vectors(painter);
  } else if (!pixels().save(&out, "PNG")) {
    return false;
  }
  return out.commit();
}

}  // namespace toolpace::ui
