/// The controller that the program runs on: choosing it, its settings and their file.

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>

#include "ask.h"
#include "main_window.h"
#include "panels/change_bar.h"
#include "panels/controller_panel.h"
#include "panels/controller_section.h"
#include "panels/dock_title.h"
#include "panels/transport_bar.h"
#include "panels/tuning_panel.h"
#include "theme/control_name.h"

namespace toolpace::studio {

void MainWindow::buildController(QWidget* tuning_page) {
  settings_bar_ = new ui::ChangeBar("settingsBar", tuning_page);
  settings_ = new ui::ControllerSection(workspace_.controller(), tuning_page);
  settings_->hide();
  tuning_->setHead(settings_);
  controller_ = new ui::ControllerPanel(this);
}

void MainWindow::connectController() {
  connect(&workspace_, &ui::Workspace::controllerChanged, this, &MainWindow::showController);
  connect(&controller_file_, &ControllerFile::modifiedChanged, this, &MainWindow::showTitle);
  connect(&controller_file_, &ControllerFile::pathChanged, this, &MainWindow::takeController);
  connect(&controller_file_, &ControllerFile::changedOutside, this, [this] {
    settings_bar_->ask(ui::ChangeBar::Reason::settings_changed_outside);
    docks_["tuningDock"]->show();
    docks_["tuningDock"]->raise();
  });
  connect(&controller_file_, &ControllerFile::takenOver, this, [this] {
    settings_bar_->hide();
    transport_->setMessage(
        tr("%1 was changed by another program and read again").arg(fileName(controller_file_.path())));
  });
  connect(&controller_file_, &ControllerFile::unreadable, this,
          [this](const Error& error) { showFailure(error, controller_file_.path()); });
  connect(settings_bar_, &ui::ChangeBar::takeFileRequested, this, [this] {
    settings_bar_->hide();
    controller_file_.takeFile();
  });
  connect(settings_bar_, &ui::ChangeBar::keepMineRequested, this, [this] {
    settings_bar_->hide();
    if (const auto kept = controller_file_.keepMine(); !kept) showFailure(kept.error(), controller_file_.path());
  });
  connect(settings_, &ui::ControllerSection::saveRequested, this, [this] { saveSettings(false); });
  connect(settings_, &ui::ControllerSection::refused, this,
          [this](const Error& error) { showFailure(error, controller_file_.path()); });
  connect(settings_, &ui::ControllerSection::resized, this, &MainWindow::showWholeTuning, Qt::QueuedConnection);
  connect(controller_, &ui::ControllerPanel::settingWanted, this, &MainWindow::takeSetting);
  connect(controller_, &ui::ControllerPanel::supplyWanted, this, [this](const PredictOptions& supply) {
    preferences_.supply = supply;
    workspace_.setSupply(supply);
  });
  connect(runs_menu_, &QMenu::aboutToShow, this, &MainWindow::fillControllers);
}

void MainWindow::askController() {
  const QString folder = preferences_.recent_controllers.isEmpty()
                             ? QString()
                             : QFileInfo(preferences_.recent_controllers.constFirst()).absolutePath();
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Settings of the controller"), folder,
                                   tr("Settings (*.ini *.txt *.cfg *.nc *.gcode *.log);;All files (*)"));
  if (!path.isEmpty()) chooseController(path);
}

void MainWindow::chooseController(const QString& settings) {
  if (mayLeaveController()) openController(settings);
}

void MainWindow::leaveController() {
  if (mayLeaveController()) controller_file_.leave();
}

bool MainWindow::openController(const QString& settings) {
  if (const auto opened = controller_file_.open(settings); !opened) {
    showFailure(opened.error(), settings);
    return false;
  }
  forgetFailure();
  studio::remember(preferences_.recent_controllers, controller_file_.path());
  return true;
}

/// Another one is chosen, or none: its page comes and goes with it.
void MainWindow::takeController() {
  settings_bar_->hide();
  const bool is_chosen = !controller_file_.path().isEmpty();
  showControllerPage(is_chosen);
  docks_[is_chosen ? "controllerDock" : "resultsDock"]->raise();
  showTitle();
}

/// In place of the limits of plan A: there is no room for the tabs of both.
void MainWindow::showControllerPage(bool shown) {
  QDockWidget &page = *docks_["controllerDock"], &limits = *docks_["limitsDock"];
  if (shown == !page.isHidden()) return;
  page.setVisible(shown);
  if (shown) limits_shown_ = !limits.isHidden();
  limits.setVisible(!shown && limits_shown_);
}

void MainWindow::showController() {
  for (ui::PlanView* view : plan_views_) view->showController(workspace_.controllerView());
  const auto& view = workspace_.controllerView();
  actions_->try_settings->setEnabled(view.found && !view.is_stale);
}

void MainWindow::takeSetting(const QString& key, double value) {
  const auto done = workspace_.controller().edit(tr("Setting %1").arg(key), key.toStdString(), value);
  if (!done) showFailure(done.error(), controller_file_.path());
}

void MainWindow::fillControllers() {
  runs_menu_->clear();
  const QString current = controller_file_.path();
  actions_->own_plan->setChecked(current.isEmpty());
  runs_menu_->addAction(actions_->own_plan);
  runs_menu_->addSeparator();
  for (const QString& path : std::as_const(preferences_.recent_controllers)) {
    QAction* action = runs_menu_->addAction(path, this, [this, path] { chooseController(path); });
    action->setCheckable(true);
    action->setChecked(path == current);
  }
  runs_menu_->addAction(actions_->open_controller);
  runs_menu_->addSeparator();
  runs_menu_->addActions({actions_->save_settings, actions_->save_settings_as, actions_->try_settings});
}

/// True when nothing would be lost or a person does not mind.
bool MainWindow::mayLeaveController() {
  if (!controller_file_.isModified()) return true;
  const QString name = fileName(controller_file_.path());
  switch (ask_about_changes(this, tr("The settings “%1” have changes that are not saved.").arg(name))) {
    case Answer::discard: return true;
    case Answer::save: return saveSettings(false);
    case Answer::cancel: break;
  }
  return false;
}

/// False when a person thought better of it, or it failed.
bool MainWindow::saveSettings(bool ask) {
  QString path = controller_file_.path();
  if (path.isEmpty()) return false;
  if (ask) {
    path = QFileDialog::getSaveFileName(this, tr("Save the settings"), path, tr("All files (*)"));
  } else if (!controller_file_.isFileKnown() && !ask_to_replace(this, fileName(path))) {
    return false;
  }
  return !path.isEmpty() && storeSettingsAs(path);
}

bool MainWindow::storeSettingsAs(const QString& path) {
  if (!mayWrite(path, Output::settings)) return false;
  if (const auto saved = controller_file_.save(path); !saved) {
    showFailure(saved.error(), path);
    return false;
  }
  settings_bar_->hide();
  studio::remember(preferences_.recent_controllers, controller_file_.path());
  transport_->setMessage(tr("saved %1").arg(fileName(path)));
  return true;
}

/// As the tool bar shows it.
QString MainWindow::controllerName() const {
  const auto& text = workspace_.controllerView().chosen;
  if (!text) return "Toolpace";
  const auto title = controller_title(text->settings.controller);
  return QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()));
}

}  // namespace toolpace::studio
