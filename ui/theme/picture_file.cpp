#include "theme/picture_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QStringList>
#include <QSvgGenerator>
#include <optional>

#include "toolpace/io/output_file.h"

namespace toolpace::ui {
namespace {

constexpr double kPointsPerPixel = 72.0 / kDotsPerInch;

bool draw(QPaintDevice& device, const Drawing& drawing) {
  QPainter painter(&device);
  if (painter.isActive()) drawing.vectors(painter);
  return painter.end();
}

bool draw_png(QIODevice& out, const Drawing& drawing) { return drawing.pixels().save(&out, "PNG"); }

bool draw_svg(QIODevice& out, const Drawing& drawing) {
  QSvgGenerator svg;
  svg.setOutputDevice(&out);
  svg.setSize(drawing.size);
  svg.setViewBox(QRect({0, 0}, drawing.size));
  svg.setResolution(kDotsPerInch);  // what was drawn before and is played back counts in the same pixels
  return draw(svg, drawing);
}

bool draw_pdf(QIODevice& out, const Drawing& drawing) {
  QPdfWriter pdf(&out);
  pdf.setResolution(kDotsPerInch);
  pdf.setPageSize(QPageSize(QSizeF(drawing.size) * kPointsPerPixel, QPageSize::Point));
  pdf.setPageMargins({});
  return draw(pdf, drawing);
}

struct Format {
  const char* suffix;
  bool vectors;
  bool (*draw)(QIODevice&, const Drawing&);
};
constexpr Format kFormats[] = {{"png", false, draw_png}, {"svg", true, draw_svg}, {"pdf", true, draw_pdf}};

Result<const Format*> format_of(const QString& file, bool has_vectors) {
  const QString suffix = QFileInfo(file).suffix();
  QStringList known;
  for (const Format& format : kFormats) {
    if (format.vectors && !has_vectors) continue;
    if (suffix.isEmpty() || suffix.compare(QLatin1String(format.suffix), Qt::CaseInsensitive) == 0) return &format;
    known << '.' + QString(format.suffix);
  }
  return tl::unexpected(Error{ErrorKind::usage,
                              "picture-format-unknown",
                              "no picture is written as ." + suffix.toStdString(),
                              "use one of " + known.join(", ").toStdString(),
                              {file.toStdString(), 0, 0},
                              {}});
}

}  // namespace

Result<void> check_picture_name(const QString& file, bool has_vectors) {
  if (auto format = format_of(file, has_vectors); !format) return tl::unexpected(format.error());
  return {};
}

Result<void> save_picture(const QString& file, const Drawing& drawing) {
  const auto format = format_of(file, static_cast<bool>(drawing.vectors));
  if (!format) return tl::unexpected(format.error());
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !(*format)->draw(buffer, drawing)) {
    return tl::unexpected(Error{ErrorKind::input,
                                "out-of-memory",
                                "there is not enough memory for this",
                                "make the window smaller, or give more memory",
                                {},
                                {}});
  }
  return write_whole_file(file.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace toolpace::ui
