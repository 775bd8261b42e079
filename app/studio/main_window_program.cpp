/// The program's file: opening it, saving it, and asking before something would be lost.

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "ask.h"
#include "main_window.h"
#include "panels/nc_panel.h"
#include "panels/transport_bar.h"

namespace toolpace::studio {
namespace {

constexpr auto kExample = ":/butterfly.ngc";

}  // namespace

void MainWindow::connectProgram() {
  using ui::Workspace;
  auto& program = workspace_.program();
  connect(&program, &ui::ProgramModel::modifiedChanged, this, &MainWindow::showTitle);
  connect(&program, &ui::ProgramModel::renamed, this, &MainWindow::showTitle);
  connect(&workspace_, &Workspace::textChanged, this,
          [this](qsizetype line) { nc_->view().setText(workspace_.program().text(), static_cast<int>(line)); });
  connect(&workspace_, &Workspace::editsWanted, &nc_->view(), &ui::NcView::commitEdit);
  connect(&workspace_, &Workspace::conflictChanged, this, &MainWindow::showConflict);
  connect(&workspace_, &Workspace::saved, this, &MainWindow::takeSaved);
  connect(&workspace_, &Workspace::saveFailed, this, [this](const Error& error, const QString& path) {
    after_saving_ = nullptr;
    showFailure(error, path);
  });
  connect(&nc_->view(), &ui::NcView::lineEdited, &program, &ui::ProgramModel::replaceLine);
  connect(&nc_->view(), &ui::NcView::lineInserted, &program, &ui::ProgramModel::insertLineAfter);
  connect(&nc_->view(), &ui::NcView::linesRemoved, &program, &ui::ProgramModel::removeLines);
  connect(&nc_->changeBar(), &ui::ChangeBar::takeFileRequested, &workspace_, &Workspace::takeFile);
  connect(&nc_->changeBar(), &ui::ChangeBar::keepMineRequested, &workspace_, &Workspace::keepMine);
}

void MainWindow::askProgram() {
  const QString folder = QFileInfo(preferences_.last_program).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a program"), folder,
      tr("NC programs (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt);;Polylines (*.csv);;All files (*)"));
  if (!path.isEmpty()) openProgram(path);
}

void MainWindow::openProgram(const QString& path) {
  if (mayLeaveProgram([this, path] { openProgram(path); })) workspace_.openFile(path);
}

void MainWindow::openExample() {
  QFile file(kExample);
  if (!mayLeaveProgram([this] { openExample(); }) || !file.open(QIODevice::ReadOnly)) return;
  workspace_.openText(file.readAll(), "butterfly.ngc");
}

void MainWindow::openLast() {
  const bool has_machine = !machine_.name().isEmpty();  // named on the command line
  if (!has_machine && !preferences_.last_machine.isEmpty()) openMachine(preferences_.last_machine);
  if (QFileInfo::exists(preferences_.last_program)) return openProgram(preferences_.last_program);
  openExample();
}

/// True when nothing would be lost or a person does not mind. Else either a person wants to stay, or `later` is done once
/// the program is saved.
bool MainWindow::mayLeaveProgram(std::function<void()> later) {
  nc_->view().commitEdit();
  if (workspace_.isSaving()) {
    after_saving_ = std::move(later);
    return false;
  }
  if (!workspace_.program().isModified()) return true;
  switch (ask_about_changes(this, tr("%1 has changes that are not saved.").arg(workspace_.program().name()))) {
    case Answer::discard: return true;
    case Answer::save: saveProgram(false, std::move(later)); break;
    case Answer::cancel: break;
  }
  return false;
}

void MainWindow::saveProgram(bool ask, std::function<void()> then) {
  if (!workspace_.document()) return;
  nc_->view().commitEdit();
  if (workspace_.isSaving()) {  // what was edited meanwhile is saved after it
    after_saving_ = [this, ask, then = std::move(then)] { saveProgram(ask, then); };
    return;
  }
  const auto& program = workspace_.program();
  QString path = program.path();
  if (ask || path.isEmpty()) {
    path = QFileDialog::getSaveFileName(
        this, tr("Save the program"), path.isEmpty() ? program.name() : path,
        tr("NC programs (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt);;Polylines (*.csv);;All files (*)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += "." + QFileInfo(program.name()).suffix();
  } else if (!workspace_.isFileKnown() && !ask_to_replace(this, program.name())) {
    return;
  }
  startSaving(path, std::move(then));
}

void MainWindow::storeProgramAs(const QString& path) { startSaving(path, {}); }

void MainWindow::startSaving(const QString& path, std::function<void()> then) {
  if (!mayWrite(path, Output::program)) return;
  after_saving_ = std::move(then);
  workspace_.save(QFileInfo(path).absoluteFilePath());
}

void MainWindow::takeSaved(const QString& path) {
  transport_->setMessage(tr("saved %1").arg(QFileInfo(path).fileName()));
  rememberProgram();
  showTitle();
  // Not from inside the delivery: the worker is still busy with it.
  if (auto then = std::exchange(after_saving_, nullptr)) {
    QMetaObject::invokeMethod(this, std::move(then), Qt::QueuedConnection);
  }
}

void MainWindow::rememberProgram() {
  const QString& path = workspace_.program().path();
  preferences_.last_program = path.isEmpty() ? QString() : QFileInfo(path).absoluteFilePath();
  if (!path.isEmpty()) studio::remember(preferences_.recent_programs, preferences_.last_program);
}

void MainWindow::showConflict(ui::Workspace::Conflict conflict) {
  using Conflict = ui::Workspace::Conflict;
  ui::ChangeBar& bar = nc_->changeBar();
  if (conflict == Conflict::none) return bar.hide();
  bar.ask(conflict == Conflict::reload ? ui::ChangeBar::Reason::reload : ui::ChangeBar::Reason::changed_outside);
  docks_["programDock"]->show();
  docks_["programDock"]->raise();
}

}  // namespace toolpace::studio
