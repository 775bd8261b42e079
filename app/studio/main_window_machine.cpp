/// The machine's file: opening it, saving it, and asking before something would be lost.

#include <QFileDialog>
#include <QFileInfo>

#include "ask.h"
#include "import_dialog.h"
#include "main_window.h"
#include "panels/change_bar.h"
#include "panels/transport_bar.h"
#include "toolpace/machine/read_machine.h"

namespace toolpace::studio {

void MainWindow::connectMachine() {
  connect(&machine_, &MachineFile::modifiedChanged, this, &MainWindow::showTitle);
  connect(&machine_, &MachineFile::changedOutside, this, [this] {
    machine_bar_->ask(ui::ChangeBar::Reason::machine_changed_outside);
    docks_["tuningDock"]->show();
    docks_["tuningDock"]->raise();
  });
  connect(&machine_, &MachineFile::takenOver, this, [this] {
    machine_bar_->hide();
    transport_->setMessage(tr("%1 was changed by another program and read again").arg(fileName(machine_.path())));
  });
  connect(&machine_, &MachineFile::unreadable, this,
          [this](const Error& error) { showFailure(error, machine_.path()); });
  connect(machine_bar_, &ui::ChangeBar::takeFileRequested, this, [this] {
    machine_bar_->hide();
    machine_.takeFile();
  });
  connect(machine_bar_, &ui::ChangeBar::keepMineRequested, this, [this] {
    machine_bar_->hide();
    machine_.keepMine();
  });
}

void MainWindow::askMachine() {
  const QString folder = QFileInfo(preferences_.last_machine).absolutePath();
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a machine"), folder,
                                                    tr("Machine files (*.toml);;LinuxCNC configuration (*.ini);;grbl "
                                                       "settings, as $$ lists them (*.txt);;All files (*)"));
  if (!path.isEmpty()) chooseMachine(path);
}

/// Shows what would be taken before it is.
void MainWindow::importMachine() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Import the settings of a controller"), {},
                                                    tr("Settings (*.ini *.txt *.cfg *.nc);;All files (*)"));
  if (path.isEmpty()) return;
  const auto setup = read_machine(path.toStdString());
  if (!setup) return showFailure(setup.error(), path);
  if (ImportDialog(fileName(path), *setup, this).exec() == QDialog::Accepted) chooseMachine(path);
}

void MainWindow::chooseMachine(const QString& path) {
  if (mayLeaveMachine()) openMachine(path);
}

void MainWindow::chooseDefaultMachine() {
  if (!mayLeaveMachine()) return;
  machine_.openDefaults();
  takeMachine();
}

bool MainWindow::openMachine(const QString& path) {
  if (const auto opened = machine_.open(path); !opened) {
    showFailure(opened.error(), path);
    return false;
  }
  forgetFailure();
  takeMachine();
  return true;
}

/// Another machine is in use: what was asked about the last one is past, and the next start begins with this one.
void MainWindow::takeMachine() {
  machine_bar_->hide();
  const bool imported = machine_.source().isEmpty() && !machine_.name().isEmpty();
  if (!imported) preferences_.last_machine = machine_.source();
  if (!machine_.path().isEmpty()) studio::remember(preferences_.recent_machines, machine_.path());
  showTitle();
  showProblems();
}

/// True when nothing would be lost or a person does not mind.
bool MainWindow::mayLeaveMachine() {
  if (!machine_.isModified()) return true;
  switch (ask_about_changes(this, tr("The machine “%1” has changes that are not saved.").arg(machineName()))) {
    case Answer::discard: return true;
    case Answer::save: return saveMachine(false);
    case Answer::cancel: break;
  }
  return false;
}

/// False when a person thought better of it, or it failed.
bool MainWindow::saveMachine(bool ask) {
  QString path = machine_.path();
  if (ask || path.isEmpty()) {
    const QString name = machine_.name().isEmpty() ? QString("machine") : machine_.name();
    path = askMachinePath(path.isEmpty() ? name + ".toml" : path);
  } else if (!machine_.isFileKnown() && !ask_to_replace(this, fileName(path))) {
    return false;
  }
  return !path.isEmpty() && storeMachineAs(path);
}

/// A machine file ends with .toml: settings of other controllers are not written over.
QString MainWindow::askMachinePath(QString suggestion) {
  for (;;) {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the machine"), suggestion, tr("Machine files (*.toml)"));
    if (path.isEmpty() || path.endsWith(".toml", Qt::CaseInsensitive)) return path;
    suggestion = path + ".toml";
    if (!QFileInfo::exists(suggestion)) return suggestion;  // else the dialog asks whether to replace it
  }
}

bool MainWindow::storeMachineAs(const QString& path) {
  if (!mayWrite(path, Output::machine)) return false;
  if (const auto saved = machine_.save(path); !saved) {
    showFailure(saved.error(), path);
    return false;
  }
  takeMachine();
  transport_->setMessage(tr("saved %1").arg(fileName(path)));
  return true;
}

QString MainWindow::machineName() const { return machine_.name().isEmpty() ? tr("default limits") : machine_.name(); }

QString MainWindow::fileName(const QString& path) { return QFileInfo(path).fileName(); }

}  // namespace toolpace::studio
