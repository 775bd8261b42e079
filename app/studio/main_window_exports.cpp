/// What the window writes for others: setpoints, pulses, pictures, the report.

#include <QBuffer>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QPrintDialog>
#include <QPrinter>

#include "export_dialog.h"
#include "main_window.h"
#include "panels/transport_bar.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "print.h"
#include "report.h"
#include "rewrite_dialog.h"
#include "theme/picture_file.h"
#include "toolpace/io/output_file.h"
#include "toolpace/io/output_guard.h"
#include "toolpace/io/setpoint_format.h"

namespace toolpace::studio {
namespace {

/// ".csv" of "Comma-separated (*.csv)".
QString extension_of(const QString& filter) {
  const qsizetype star = filter.indexOf('*');
  return star < 0 ? QString() : filter.mid(star + 1).section(')', 0, 0).section(' ', 0, 0);
}

QString suffix_of(const SetpointFormat& format) {
  return QString::fromUtf8(format.suffix.data(), static_cast<qsizetype>(format.suffix.size()));
}

}  // namespace

/// Nothing that is open may be what something else is written to. A program and a machine are saved in place; settings of
/// other controllers never are.
Result<void> MainWindow::checkOutput(const QString& path, Output output) {
  std::vector<FileRole> inputs;
  if (output != Output::program) inputs.push_back({"the program", workspace_.program().path().toStdString()});
  if (output != Output::settings)
    inputs.push_back({"the controller's settings", controller_file_.path().toStdString()});
  const bool in_place = output == Output::machine && machine_.input() == machine_.path();
  if (!in_place) inputs.push_back({"the machine file", machine_.input().toStdString()});
  if (const auto& document = workspace_.document()) {
    const auto& files = document->reading->moves.files;  // the program itself, then what it calls
    for (std::size_t i = 1; i < files.size(); ++i) inputs.push_back({"a sub-program", files[i]});
  }
  const char* what = output == Output::program    ? "the program"
                     : output == Output::machine  ? "the machine file"
                     : output == Output::settings ? "the settings"
                                                  : "the export";
  return check_outputs({{what, path.toStdString()}}, inputs);
}

/// Shows why not.
Result<void> MainWindow::mayWrite(const QString& path, Output output) {
  forgetFailure();
  auto fine = checkOutput(path, output);
  if (!fine) showFailure(fine.error(), path);
  return fine;
}

QString MainWindow::askFile(const QString& title, const QString& suffix, const QStringList& filters) {
  const auto& document = workspace_.document();
  const QString base = document ? QFileInfo(document->name).completeBaseName() : QString("toolpace");
  QString filter;
  QString path = QFileDialog::getSaveFileName(this, title, base + suffix, filters.join(";;"), &filter);
  if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += extension_of(filter);
  return path;
}

void MainWindow::fillFormats() {
  setpoint_menu_->clear();
  for (const SetpointFormat& format : setpoint_formats()) {
    const QString suffix = suffix_of(format);
    setpoint_menu_->addAction(format_title(format), this, [this, suffix] { exportSetpoints(suffix); })
        ->setObjectName("export" + suffix);
  }
}

/// Says first what will be written, and how large it gets.
void MainWindow::askExport() {
  if (!workspace_.timeline() || exporter_.isBusy()) return;
  ExportDialog dialog(workspace_.timeline()->outcome(),
                      {preferences_.axis_derivatives, preferences_.decimal_comma, preferences_.timer_hz}, this);
  if (dialog.exec() != QDialog::Accepted) return;
  preferences_.axis_derivatives = dialog.options().axis_derivatives;
  preferences_.decimal_comma = dialog.options().decimal_comma;
  actions_->axis_derivatives->setChecked(preferences_.axis_derivatives);
  actions_->decimal_comma->setChecked(preferences_.decimal_comma);
  exportSetpoints(dialog.suffix());
}

/// The dialog offers every format, the one asked for first.
void MainWindow::exportSetpoints(const QString& suffix) {
  if (!workspace_.timeline() || exporter_.isBusy()) return;
  QStringList filters;
  for (const SetpointFormat& format : setpoint_formats()) {
    const QString filter = format_title(format) + " (*" + suffix_of(format) + ")";
    suffix_of(format) == suffix ? filters.prepend(filter) : filters.append(filter);
  }
  const QString path = askFile(tr("Save setpoints"), suffix, filters);
  if (!path.isEmpty()) saveSetpoints(path);
}

void MainWindow::exportPulses() {
  if (!workspace_.timeline() || exporter_.isBusy()) return;
  constexpr double kSlowest = 1, kFastest = 1e10;
  bool fine = false;
  const double hz = QInputDialog::getDouble(this, tr("Step pulses"), tr("Frequency of the timer in Hz"),
                                            preferences_.timer_hz, kSlowest, kFastest, 0, &fine);
  if (!fine) return;
  setTimerFrequency(hz);
  const QString path = askFile(tr("Save step pulses"), ".pulses.csv", {tr("Step pulses") + " (*.pulses.csv)"});
  if (!path.isEmpty()) saveSetpoints(path);
}

void MainWindow::setTimerFrequency(double hz) { preferences_.timer_hz = hz; }

void MainWindow::saveSetpoints(const QString& path) {
  if (!workspace_.timeline() || exporter_.isBusy() || !mayWrite(path)) return;
  transport_->setTask(tr("saving"));
  transport_->setBusy(true);
  exporter_.start(workspace_.timeline()->outcome(), path,
                  {preferences_.axis_derivatives, preferences_.decimal_comma, preferences_.timer_hz});
}

/// Comes back to the dialog where no file was named.
void MainWindow::askRewrite() {
  const auto& document = workspace_.document();
  if (!document || rewriter_.isRunning()) return;
  RewriteDialog dialog({document, workspace_.readOptions(), workspace_.tuning().value(), workspace_.controller().text(),
                        workspace_.controllerView().supply, preferences_.units, theme_},
                       this);
  const QString suffix =
      "." + (QFileInfo(document->name).suffix().isEmpty() ? QString("ngc") : QFileInfo(document->name).suffix());
  while (dialog.exec() == QDialog::Accepted && dialog.found()) {
    const QString path =
        askFile(tr("Save the program for the controller"), "-short" + suffix,
                {tr("NC programs (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt)"), tr("All files (*)")});
    if (path.isEmpty()) continue;
    storeRewritten(dialog.found(), path);
    break;
  }
}

void MainWindow::storeRewritten(std::shared_ptr<const ui::RewriteFound> found, const QString& path) {
  if (rewriter_.isRunning() || !mayWrite(path)) return;
  transport_->setTask(tr("saving"));
  transport_->setBusy(true);
  rewriter_.save(std::move(found), path);
}

void MainWindow::connectExporter() {
  connect(&rewriter_, &ui::RewriteService::progressed, transport_, &ui::TransportBar::setProgress);
  connect(&rewriter_, &ui::RewriteService::finished, this, [this] {
    transport_->setBusy(workspace_.isBusy());
    showState();
  });
  connect(&rewriter_, &ui::RewriteService::saved, this,
          [this](const QString& file) { transport_->setMessage(tr("saved %1").arg(QFileInfo(file).fileName())); });
  connect(&rewriter_, &ui::RewriteService::failed, this,
          [this](const Error& error, const QString& file) { showFailure(error, file); });
  connect(transport_, &ui::TransportBar::cancelRequested, this, [this] { rewriter_.cancel(); });
  connect(&exporter_, &ui::ExportService::progressed, transport_, &ui::TransportBar::setProgress);
  connect(&exporter_, &ui::ExportService::saved, this, [this](const QString& file, qulonglong rows) {
    transport_->setBusy(workspace_.isBusy());
    showState();
    transport_->setMessage(tr("saved %1 rows to %2").arg(rows).arg(QFileInfo(file).fileName()));
  });
  connect(&exporter_, &ui::ExportService::failed, this, [this](const Error& error, const QString& file) {
    transport_->setBusy(workspace_.isBusy());
    showState();
    showFailure(error, file);
  });
  connect(transport_, &ui::TransportBar::cancelRequested, this, [this] { exporter_.cancel(); });
}

void MainWindow::exportPicture(Picture picture) {
  const QString png = tr("Picture (*.png)");
  QStringList filters = {png};
  if (picture != Picture::window) filters << tr("Vector graphic (*.svg)") << tr("PDF (*.pdf)");
  const QString suffix = picture == Picture::contour ? "-contour.png"
                         : picture == Picture::plots ? "-plots.png"
                                                     : ".png";
  const QString path = askFile(tr("Save a picture"), suffix, filters);
  if (!path.isEmpty()) savePicture(picture, path);
}

Result<void> MainWindow::savePicture(Picture picture, const QString& path) {
  if (auto may = mayWrite(path); !may) return may;
  const ui::Drawing whole{size(), [this] { return grab().toImage(); }};
  auto saved = picture == Picture::contour ? contour_->exportPicture(path)
               : picture == Picture::plots ? profile_->exportPicture(path)
                                           : ui::save_picture(path, whole);
  if (saved) {
    transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  } else {
    showFailure(saved.error(), path);
  }
  return saved;
}

void MainWindow::exportReport() {
  if (!workspace_.timeline()) return;
  const QString path = askFile(tr("Save the report"), "-report.html", {tr("Web page (*.html)"), tr("PDF (*.pdf)")});
  if (!path.isEmpty()) saveReport(path);
}

ReportParts MainWindow::reportParts(bool with_pictures) {
  const auto png = [](const QPixmap& pixmap) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    pixmap.save(&buffer, "PNG");
    return bytes;
  };
  return {workspace_.plan(),
          workspace_.pinned(),
          workspace_.document()->name,
          tr("Machine: %1").arg(machine_button_->text()),
          with_pictures ? png(contour_->grab()) : QByteArray(),
          with_pictures ? png(profile_->grab()) : QByteArray(),
          preferences_.units};
}

bool MainWindow::saveReport(const QString& path) {
  if (!workspace_.timeline() || !mayWrite(path)) return false;
  const ReportParts parts = reportParts(true);
  const bool pages = path.endsWith(".pdf", Qt::CaseInsensitive);
  const QByteArray bytes = pages ? report_pdf(parts) : report_html(parts).toUtf8();
  const auto written = write_whole_file(path.toStdString(), bytes.toStdString());
  if (written) {
    transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  } else {
    showFailure(written.error(), path);
  }
  return written.has_value();
}

void MainWindow::print() {
  if (!workspace_.timeline()) return;
  QPrinter printer(QPrinter::HighResolution);
  printer.setDocName(workspace_.document()->name);
  QPrintDialog dialog(&printer, this);
  dialog.setObjectName("printDialog");
  if (dialog.exec() != QDialog::Accepted) return;
  // Where there is no printer, Qt offers a file, which may not be there to be written.
  const QString file = printer.outputFileName();
  const bool to_file = printer.outputFormat() == QPrinter::PdfFormat;
  const bool writable = !to_file || (!file.isEmpty() && QFile(file).open(QIODevice::Append));
  if (!writable || !printTo(printer)) transport_->setMessage(tr("the printer takes nothing"));
}

// Paper is light, whatever the window is.
bool MainWindow::printTo(QPrinter& printer) {
  const auto dress = [this](const ui::Theme& theme) {
    contour_->setTheme(theme);
    profile_->setTheme(theme);
  };
  dress(ui::light_theme());
  const bool printed = print_pages(printer, reportParts(false), {contour_->drawing(), profile_->drawing()});
  dress(theme_);
  return printed;
}

}  // namespace toolpace::studio
