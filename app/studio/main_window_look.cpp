#include <QApplication>
#include <QDockWidget>
#include <QHeaderView>
#include <QLibraryInfo>
#include <QTableView>
#include <QToolBar>

#include "main_window.h"
#include "panels/causes_panel.h"
#include "panels/circle_panel.h"
#include "panels/dock_title.h"
#include "panels/loss_panel.h"
#include "panels/nc_panel.h"
#include "panels/problems_panel.h"
#include "panels/reading_page.h"
#include "panels/results_panel.h"
#include "panels/single_move_page.h"
#include "panels/stepper_page.h"
#include "panels/sweep_panel.h"
#include "panels/transport_bar.h"
#include "panels/tuning_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"
#include "theme/appearance.h"
#include "theme/control_name.h"
#include "theme/icons.h"

namespace toolpace::studio {

void MainWindow::setDark(bool dark) {
  if (preferences_.dark == dark) return;
  preferences_.dark = dark;
  actions_->dark->setChecked(dark);
  applyAppearance();
}

void MainWindow::setTouch(bool touch) {
  if (preferences_.touch == touch) return;
  preferences_.touch = touch;
  actions_->touch->setChecked(touch);
  applyAppearance();
  showWelcome();
}

void MainWindow::dressApplication() {
  theme_ = preferences_.dark ? ui::dark_theme() : ui::light_theme();
  ui::apply_theme(*qApp, theme_, preferences_.touch);
}

void MainWindow::applyAppearance() {
  dressApplication();
  actions_->setTheme(theme_);
  for (auto* button : {machine_button_, export_button_}) {
    button->setIcon(ui::icon(button == machine_button_ ? "machine" : "export", theme_));
  }
  for (ui::PlanView* view : plan_views_) view->setTheme(theme_);
  for (const auto& [name, title] : titles_) title->setTheme(theme_);
  problems_->setTheme(theme_);
  welcome_->setTheme(theme_);
  single_move_->setTheme(theme_);
  stepper_->setTheme(theme_);
  constexpr int kRow = 20, kTouchRow = 48;
  for (auto* table : findChildren<QTableView*>()) {
    table->verticalHeader()->setDefaultSectionSize(preferences_.touch ? kTouchRow : kRow);
  }
}

void MainWindow::setInch(bool inch) {
  preferences_.units.inch = inch;
  showUnits();
}

void MainWindow::setPerMinute(bool per_minute) {
  preferences_.units.per_minute = per_minute;
  showUnits();
}

void MainWindow::showUnits() {
  const ui::Units units = preferences_.units;
  actions_->inch->setChecked(units.inch);
  actions_->per_minute->setChecked(units.per_minute);
  for (ui::PlanView* view : plan_views_) view->setUnits(units);
  reading_->setUnits(units);
  unit_button_->setText(ui::display_unit(ui::Quantity::length, units).text);
  speed_unit_button_->setText(ui::display_unit(ui::Quantity::speed, units).text);
}

void MainWindow::setLanguage(const QString& language) {
  const bool chinese = language.startsWith("zh");
  preferences_.language = chinese ? "zh_CN" : "en";
  (chinese ? actions_->chinese : actions_->english)->setChecked(true);
  QCoreApplication::removeTranslator(&translator_);
  QCoreApplication::removeTranslator(&qt_translator_);
  if (chinese) {
    if (qt_translator_.load("qtbase_zh_CN", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
      QCoreApplication::installTranslator(&qt_translator_);
    }
    if (translator_.load(":/translations/toolpace_zh_CN.qm")) QCoreApplication::installTranslator(&translator_);
  }
  retranslate();
}

void MainWindow::retranslate() {
  actions_->retranslate();
  const auto title = [this](const char* dock, const QString& text) { docks_[dock]->setWindowTitle(text); };
  title("programDock", tr("NC program"));
  title("plotsDock", tr("Motion along the path"));
  title("tuningDock", tr("Tuning"));
  title("resultsDock", tr("Result"));
  title("controllerDock", tr("Controller"));
  title("limitsDock", tr("Limits"));
  title("lossDock", tr("Lines"));
  title("sweepDock", tr("Depth"));
  title("circleDock", tr("Circle"));
  title("singleMoveDock", tr("Single move"));
  title("stepperDock", tr("Stepper pulses"));
  title("traceDock", tr("Trace"));
  title("tuneDock", tr("Tune"));
  title("drivesDock", tr("Drives"));
  title("spectrumDock", tr("Spectrum and speeds"));
  title("readingDock", tr("Reading options"));
  const std::pair<QMenu*, QString> menus[] = {
      {file_menu_, tr("&File")},        {edit_menu_, tr("&Edit")},     {plan_menu_, tr("&Plan")},
      {view_menu_, tr("&View")},        {help_menu_, tr("&Help")},     {recent_menu_, tr("Open re&cent")},
      {machine_menu_, tr("&Machine")},  {export_menu_, tr("&Export")}, {setpoint_menu_, tr("Setpoints &as")},
      {panels_menu_, tr("&Panels")},    {runs_menu_, tr("R&uns on")},  {preset_menu_, tr("Prese&ts")},
      {language_menu_, tr("&Language")}};
  for (const auto& [menu, text] : menus) menu->setTitle(text);
  export_button_->setText(tr("Export"));
  export_button_->setToolTip(tr("Save setpoints and pictures"));
  ui::name_control(machine_button_, tr("Machine"), tr("Machine file: limits and defaults"));
  ui::name_control(runs_button_, tr("Runs on"), tr("Toolpace's plan, or a controller with its settings file"));
  ui::name_control(unit_button_, tr("Switch between millimetres and inches"));
  ui::name_control(speed_unit_button_, tr("Switch between speeds a second and a minute"));
  tool_bar_->setWindowTitle(tr("Tools"));
  showProblems();
  showTitle();
  showState();
  showCursor(workspace_.cursorTime());
}

}  // namespace toolpace::studio
