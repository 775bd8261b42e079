#include "report.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPdfWriter>
#include <QTextDocument>

#include "panels/result_model.h"
#include "toolpace/machine/setup.h"

namespace toolpace::studio {
namespace {

constexpr auto kStyle =
    "body{font:14px/1.5 sans-serif;color:#1B1F24;margin:32px auto;max-width:960px;padding:0 16px}h1{font-size:22px}"
    "h2{font-size:16px;margin-top:32px}table{border-collapse:collapse}td,th{padding:4px 16px 4px 0;text-align:right;"
    "border-bottom:1px solid #D7DBE0;font-variant-numeric:tabular-nums}td:first-child,th:first-child{text-align:left}"
    "th{color:#5B6470;font-weight:600}img{max-width:100%;border:1px solid "
    "#D7DBE0}.bad{color:#C62828}.good{color:#2E7D32}"
    "pre{background:#F5F6F8;padding:16px;overflow:auto}";

QString cell(const QString& text, const char* tag = "td") {
  return QString("<%1>%2</%1>").arg(QLatin1String(tag), text.toHtmlEscaped());
}

QString figures(const ReportParts& parts) {
  ui::ResultModel model;
  model.setUnit(parts.unit);
  model.setPlans(parts.plan, parts.pinned);
  const int columns = parts.pinned ? model.columnCount() : ui::ResultModel::kPlanB;
  QString html = "<table><tr><th></th>";
  for (int c = 1; c < columns; ++c) html += cell(model.headerData(c, Qt::Horizontal, Qt::DisplayRole).toString(), "th");
  html += "</tr>";
  for (int row = 0; row < model.rowCount(); ++row) {
    html += "<tr>";
    for (int c = 0; c < columns; ++c) html += cell(model.index(row, c).data().toString());
    html += "</tr>";
  }
  return html + "</table>";
}

QString proof(const ReportParts& parts) {
  if (!parts.plan.proof) return {};
  const Diagnostics broken = ui::problems_of(parts.plan.proof->report);
  QString html = "<h2>" + QCoreApplication::translate("toolpace::studio::Report", "Proof") + "</h2>";
  if (broken.empty()) {
    const QString text =
        QCoreApplication::translate("toolpace::studio::Report", "%1 setpoints were read back and keep every limit.");
    return html + "<p class='good'>" + text.arg(parts.plan.proof->report.rows) + "</p>";
  }
  html += "<ul class='bad'>";
  for (const auto& d : broken) html += "<li>" + QString::fromStdString(d.message).toHtmlEscaped() + "</li>";
  return html + "</ul>";
}

QString picture(const QString& title, const QByteArray& png) {
  if (png.isEmpty()) return {};
  return QString("<h2>%1</h2><img alt='%1' src='data:image/png;base64,%2'>")
      .arg(title.toHtmlEscaped(), QString::fromLatin1(png.toBase64()));
}

}  // namespace

QString report_html(const ReportParts& parts) {
  const Job& job = *parts.plan.timeline->outcome()->job;
  const QString title = parts.program + " · " + ui::duration_text(parts.plan.timeline->duration());
  const auto machine = format_setup({job.machine, job.options});
  const QString setup = QString::fromStdString(machine ? *machine : machine.error().message);
  return "<!DOCTYPE html><html><head><meta charset='utf-8'><title>" + title.toHtmlEscaped() + "</title><style>" +
         QString(kStyle) + "</style></head><body><h1>" + title.toHtmlEscaped() + "</h1><p>" +
         parts.machine.toHtmlEscaped() + "</p>" + figures(parts) + proof(parts) +
         picture(QCoreApplication::translate("toolpace::studio::Report", "Contour"), parts.contour_png) +
         picture(QCoreApplication::translate("toolpace::studio::Report", "Motion"), parts.plots_png) + "<h2>" +
         QCoreApplication::translate("toolpace::studio::Report", "Machine and options") + "</h2><pre>" +
         setup.toHtmlEscaped() + "</pre></body></html>\n";
}

QByteArray report_pdf(const ReportParts& parts) {
  constexpr int kMargin = 15;  // mm
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter pdf(&buffer);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(kMargin, kMargin, kMargin, kMargin), QPageLayout::Millimeter);
    QTextDocument document;
    // A text document knows no share of the page as a width: what there is between the margins, at 96 a inch.
    document.setHtml(report_html(parts).replace("<img ", "<img width='640' "));
    document.print(&pdf);
  }
  return bytes;
}

}  // namespace toolpace::studio
