#include "print.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPrinter>
#include <QScreen>
#include <QTextDocument>
#include <algorithm>

namespace toolpace::studio {
namespace {

/// Laid out as on the screen.
void print_text(QPainter& painter, QPrinter& printer, const QString& html) {
  const double scale = printer.logicalDpiY() / QGuiApplication::primaryScreen()->logicalDotsPerInchY();
  const QSizeF page = printer.pageRect(QPrinter::DevicePixel).size() / scale;
  QTextDocument document;
  document.setHtml(html);
  document.setPageSize(page);
  for (int i = 0; i < document.pageCount(); ++i) {
    if (i > 0) printer.newPage();
    painter.save();
    painter.scale(scale, scale);
    painter.translate(0, -i * page.height());
    document.drawContents(&painter, QRectF(0, i * page.height(), page.width(), page.height()));
    painter.restore();
  }
}

void print_drawing(QPainter& painter, QPrinter& printer, const ui::Drawing& drawing) {
  printer.newPage();
  const QSizeF page = printer.pageRect(QPrinter::DevicePixel).size();
  const double scale = std::min(page.width() / drawing.size.width(), page.height() / drawing.size.height());
  painter.save();
  painter.translate((page.width() - scale * drawing.size.width()) / 2, 0);
  painter.scale(scale, scale);
  painter.setClipRect(QRectF({0, 0}, QSizeF(drawing.size)));
  drawing.vectors(painter);
  painter.restore();
}

}  // namespace

bool print_pages(QPrinter& printer, const ReportParts& parts, const std::vector<ui::Drawing>& drawings) {
  // Drawings count their fonts in points and all else in the pixels of a screen: at its resolution both are of one scale. What a
  // printer gets are lines and letters, not pixels.
  printer.setResolution(ui::kDotsPerInch);
  QPainter painter;
  if (!painter.begin(&printer)) return false;
  print_text(painter, printer, report_html(parts));
  for (const ui::Drawing& drawing : drawings) print_drawing(painter, printer, drawing);
  return painter.end();
}

}  // namespace toolpace::studio
