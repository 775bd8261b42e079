#include <QBuffer>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>

#include "main_window.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/transport_bar.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "report.h"
#include "toolpace/io/output_file.h"
#include "toolpace/machine/import_machine.h"

namespace toolpace::studio {
namespace {

/// ".csv" of "Comma-separated (*.csv)".
QString extension_of(const QString& filter) {
  const qsizetype star = filter.indexOf('*');
  return star < 0 ? QString() : filter.mid(star + 1).section(')', 0, 0).section(' ', 0, 0);
}

/// Extension and title of each format of setpoint files.
std::vector<std::pair<QString, QString>> setpoint_formats() {
  return {{".csv", MainWindow::tr("Comma-separated")},
          {".npy", MainWindow::tr("NumPy array")},
          {".npz", MainWindow::tr("NumPy archive")},
          {".halstream", MainWindow::tr("LinuxCNC halstreamer")},
          {".semicolon.csv", MainWindow::tr("Semicolons")}};
}

Result<Setup> read_any_machine(const QString& path, const Setup& base) {
  const bool ini = path.endsWith(".ini", Qt::CaseInsensitive);
  const bool dump = path.endsWith(".txt", Qt::CaseInsensitive);
  if (!ini && !dump) return load_machine(path);
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return tl::unexpected(Error{ErrorKind::io, "cannot-open", file.errorString().toStdString(), {}, {}, {}});
  }
  const std::string text = file.readAll().toStdString();
  const std::string name = path.toStdString();
  return ini ? import_linuxcnc_ini(text, name, base) : import_grbl_dump(text, name, base);
}

/// Rows of a menu's keys below its title, those of its submenus among them.
QString keys_of(const QMenu& menu, bool titled = true) {
  QString rows;
  if (titled) {
    rows = QString("<tr><td colspan='2' style='padding-top:8px'><b>%1</b></td></tr>")
               .arg(QString(menu.title()).remove('&').remove(QRegularExpression("\\(.\\)$")).toHtmlEscaped());
  }
  for (const QAction* action : menu.actions()) {
    if (action->menu()) rows += keys_of(*action->menu(), false);
    if (action->shortcut().isEmpty()) continue;
    rows += QString("<tr><td style='padding-right:24px'>%1</td><td align='right'>%2</td></tr>")
                .arg(action->text().remove('&').toHtmlEscaped(), action->shortcut().toString(QKeySequence::NativeText));
  }
  return rows;
}

}  // namespace

void MainWindow::askProgram() {
  const QString folder = QFileInfo(preferences_.last_program).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a program"), folder,
      tr("NC programs (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt);;Polylines (*.csv);;All files (*)"));
  if (!path.isEmpty()) openProgram(path);
}

void MainWindow::askMachine() {
  const QString folder = QFileInfo(preferences_.last_machine).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a machine"), folder,
      tr("Machine files (*.toml);;LinuxCNC configuration (*.ini);;grbl settings, as $$ lists them (*.txt)"));
  if (!path.isEmpty()) openMachine(path);
}

bool MainWindow::openMachine(const QString& path) {
  const auto setup = read_any_machine(path, workspace_.tuning().value());
  if (!setup) {
    showFailure(setup.error(), path);
    return false;
  }
  workspace_.tuning().replace(tr("Open machine"), *setup);
  const bool ours = path.endsWith(".toml", Qt::CaseInsensitive) && !path.startsWith(":/");
  if (path.endsWith(".toml", Qt::CaseInsensitive)) workspace_.tuning().undoStack().setClean();
  machine_ = {ours ? QFileInfo(path).absoluteFilePath() : QString(), QFileInfo(path).completeBaseName()};
  if (ours) {
    preferences_.last_machine = machine_.path;
    studio::remember(preferences_.recent_machines, machine_.path);
  }
  showTitle();
  return true;
}

void MainWindow::saveMachine(bool ask) {
  QString path = machine_.path;
  if (ask || path.isEmpty()) {
    const QString suggestion = path.isEmpty() ? QString("machine.toml") : path;
    path = QFileDialog::getSaveFileName(this, tr("Save the machine"), suggestion, tr("Machine files (*.toml)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += ".toml";
  }
  storeMachineAs(path);
}

void MainWindow::storeMachineAs(const QString& path) {
  if (const auto stored = store_machine(path, workspace_.tuning().value()); !stored) {
    return showFailure(stored.error(), path);
  }
  machine_ = {QFileInfo(path).absoluteFilePath(), QFileInfo(path).completeBaseName()};
  preferences_.last_machine = machine_.path;
  studio::remember(preferences_.recent_machines, machine_.path);
  workspace_.tuning().undoStack().setClean();
  transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  showTitle();
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
  for (const auto& [suffix, title] : setpoint_formats()) {
    setpoint_menu_->addAction(title, this, [this, ending = suffix] { exportSetpoints(ending); })
        ->setObjectName("export" + suffix);
  }
}

/// The dialog offers every format, the one asked for first.
void MainWindow::exportSetpoints(const QString& suffix) {
  if (!workspace_.timeline() || exporter_.isBusy()) return;
  QStringList filters;
  for (const auto& [ending, title] : setpoint_formats()) {
    const QString filter = title + " (*" + ending + ")";
    ending == suffix ? filters.prepend(filter) : filters.append(filter);
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
  if (!workspace_.timeline() || exporter_.isBusy()) return;
  transport_->setTask(tr("saving"));
  transport_->setBusy(true);
  exporter_.start(workspace_.timeline()->outcome(), path,
                  {preferences_.axis_derivatives, preferences_.decimal_comma, preferences_.timer_hz});
}

void MainWindow::connectExporter() {
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

bool MainWindow::savePicture(Picture picture, const QString& path) {
  const bool saved = picture == Picture::contour ? contour_->exportPicture(path)
                     : picture == Picture::plots ? profile_->exportPicture(path)
                                                 : grab().save(path);
  if (saved) {
    transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  } else {
    showFailure({ErrorKind::io, "cannot-write", "cannot be written", "check the folder and the extension", {}, {}},
                path);
  }
  return saved;
}

void MainWindow::exportReport() {
  if (!workspace_.timeline()) return;
  const QString path = askFile(tr("Save the report"), "-report.html", {tr("Web page (*.html)")});
  if (!path.isEmpty()) saveReport(path);
}

bool MainWindow::saveReport(const QString& path) {
  if (!workspace_.timeline()) return false;
  const auto png = [](const QPixmap& pixmap) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    pixmap.save(&buffer, "PNG");
    return bytes;
  };
  ReportParts parts{workspace_.plan(),
                    workspace_.pinned(),
                    workspace_.document()->name,
                    machine_button_->text(),
                    png(contour_->grab()),
                    png(profile_->grab()),
                    preferences_.inch ? ui::LengthUnit::inch : ui::LengthUnit::mm};
  const auto written = write_whole_file(path.toStdString(), report_html(parts).toStdString());
  if (written) {
    transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  } else {
    showFailure(written.error(), path);
  }
  return written.has_value();
}

void MainWindow::goToProblem() {
  const auto& all = workspace_.problems();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& problem = all[(next_problem_ + i) % all.size()];
    if (problem.where.line == 0) continue;
    next_problem_ = (next_problem_ + i + 1) % all.size();
    const int line = static_cast<int>(problem.where.line);
    nc_->view().setCurrentLine(line);
    workspace_.setCursorLine(static_cast<std::uint32_t>(line));
    transport_->setMessage(ui::message_text(problem.code, problem.message));
    return;
  }
}

void MainWindow::goToSlowest() {
  const auto& timeline = workspace_.timeline();
  if (!timeline || timeline->worst_lines().empty()) return;
  const std::uint32_t line = timeline->worst_lines()[next_slow_++ % timeline->worst_lines().size()];
  nc_->view().setCurrentLine(static_cast<int>(line));
  workspace_.setCursorTime(timeline->lines()[line].begin);
}

void MainWindow::showKeys() {
  // By menu, in two columns of about the same height.
  const QString left = keys_of(*file_menu_) + keys_of(*edit_menu_) + keys_of(*view_menu_);
  const QString right = keys_of(*plan_menu_) + keys_of(*help_menu_);
  const QString column = QStringLiteral("<td><table cellspacing='2'>%1</table></td>");
  QMessageBox box(QMessageBox::NoIcon, tr("Keys"),
                  "<table><tr>" + column.arg(left) + "<td width='40'></td>" + column.arg(right) + "</tr></table>",
                  QMessageBox::Close, this);
  box.setObjectName("keysBox");
  box.exec();
}

void MainWindow::showAbout() {
  QMessageBox box(QMessageBox::NoIcon, tr("About Toolpace"),
                  "<b>Toolpace " TOOLPACE_VERSION "</b><p>" + tr("Plans the motion of CNC machines.") +
                      "</p><p>GPL-3.0-or-later</p>",
                  QMessageBox::Close, this);
  box.setObjectName("aboutBox");
  box.exec();
}

}  // namespace toolpace::studio
