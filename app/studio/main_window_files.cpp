#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "jobs/regular_file.h"
#include "main_window.h"
#include "panels/transport_bar.h"
#include "toolpace/machine/import_machine.h"

namespace toolpace::studio {
namespace {

Result<Setup> read_any_machine(const QString& path, const Setup& base) {
  if (!path.startsWith(":/")) {
    if (auto regular = ui::check_regular_file(path); !regular) return tl::unexpected(regular.error());
  }
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

}  // namespace

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
  if (path.endsWith(".toml", Qt::CaseInsensitive)) workspace_.tuning().setClean();
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
  workspace_.tuning().setClean();
  transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  showTitle();
}

}  // namespace toolpace::studio
