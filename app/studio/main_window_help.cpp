/// What is wrong and what is slow, one after the other; keys, and what this is.

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QUrl>

#include "handbook.h"
#include "main_window.h"
#include "models/presets.h"
#include "panels/nc_panel.h"
#include "panels/number_field.h"
#include "panels/problems_panel.h"
#include "panels/reading_page.h"
#include "panels/transport_bar.h"
#include "panels/tuning_panel.h"
#include "version.h"

namespace toolpace::studio {
namespace {

QString heading(const QString& text) {
  return QString("<tr><td colspan='2' style='padding-top:8px'><b>%1</b></td></tr>").arg(text);
}

QString row(const QString& what, const QString& how) {
  return QString("<tr><td style='padding-right:24px'>%1</td><td align='right'>%2</td></tr>").arg(what, how);
}

/// Rows of a menu's keys below its title, those of its submenus among them.
QString keys_of(const QMenu& menu, bool titled = true) {
  QString rows;
  if (titled) {
    rows = heading(QString(menu.title()).remove('&').remove(QRegularExpression("\\(.\\)$")).toHtmlEscaped());
  }
  for (const QAction* action : menu.actions()) {
    if (action->menu()) rows += keys_of(*action->menu(), false);
    if (action->shortcut().isEmpty()) continue;
    rows += row(action->text().remove('&').toHtmlEscaped(), action->shortcut().toString(QKeySequence::NativeText));
  }
  return rows;
}

/// What the mouse does where no menu tells it.
QString mouse_actions() {
  const std::pair<const char*, const char*> actions[] = {
      {QT_TRANSLATE_NOOP("MouseActions", "Go there: program, preview, plots, overview"),
       QT_TRANSLATE_NOOP("MouseActions", "click")},
      {QT_TRANSLATE_NOOP("MouseActions", "Zoom about the mouse: preview, plots"),
       QT_TRANSLATE_NOOP("MouseActions", "wheel")},
      {QT_TRANSLATE_NOOP("MouseActions", "Move the picture, or the time shown"),
       QT_TRANSLATE_NOOP("MouseActions", "drag")},
      {QT_TRANSLATE_NOOP("MouseActions", "Turn the preview"),
       QT_TRANSLATE_NOOP("MouseActions", "right drag, or Ctrl and drag")},
      {QT_TRANSLATE_NOOP("MouseActions", "Show all of it: preview, plots"),
       QT_TRANSLATE_NOOP("MouseActions", "double click")},
      {QT_TRANSLATE_NOOP("MouseActions", "Edit a line of the program"),
       QT_TRANSLATE_NOOP("MouseActions", "double click")},
      {QT_TRANSLATE_NOOP("MouseActions", "Open a program or a machine"),
       QT_TRANSLATE_NOOP("MouseActions", "drop a file on the window")}};
  const auto text = [](const char* source) {
    return QCoreApplication::translate("MouseActions", source).toHtmlEscaped();
  };
  QString rows = heading(QCoreApplication::translate("MouseActions", "Mouse"));
  for (const auto& [what, how] : actions) rows += row(text(what), text(how));
  return rows;
}

}  // namespace

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

void MainWindow::showHandbook() {
  const QString page = handbook_page(QCoreApplication::applicationDirPath(), preferences_.language);
  if (!page.isEmpty() && QDesktopServices::openUrl(QUrl::fromLocalFile(page))) return;
  const QString text =
      page.isEmpty()
          ? tr("The handbook is not here. The package toolpace-doc brings it, and scripts/handbook makes it.")
          : tr("No browser opened the handbook. It is the page\n%1").arg(page);
  QMessageBox box(QMessageBox::NoIcon, tr("Handbook"), text, QMessageBox::Close, this);
  box.setObjectName("handbookBox");
  box.exec();
}

void MainWindow::showKeys() {
  // By menu, in two columns of about the same height.
  const QString left = keys_of(*file_menu_) + keys_of(*edit_menu_) + keys_of(*view_menu_);
  const QString right = keys_of(*plan_menu_) + keys_of(*help_menu_) + mouse_actions();
  const QString column = QStringLiteral("<td><table cellspacing='2'>%1</table></td>");
  QMessageBox box(QMessageBox::NoIcon, tr("Keys"),
                  "<table><tr>" + column.arg(left) + "<td width='40'></td>" + column.arg(right) + "</tr></table>",
                  QMessageBox::Close, this);
  box.setObjectName("keysBox");
  box.exec();
}

void MainWindow::showAbout() {
  QMessageBox box(QMessageBox::NoIcon, tr("About Toolpace"),
                  "<b>Toolpace " + QString(toolpace::version()) + "</b><p>" + tr("Plans the motion of CNC machines.") +
                      "</p><p>GPL-3.0-or-later</p>",
                  QMessageBox::Close, this);
  box.setObjectName("aboutBox");
  box.exec();
}

/// What the window can do about a problem, as far as a person agrees.
void MainWindow::remedy(ui::ProblemAction action) {
  using ui::ProblemAction;
  if (action == ProblemAction::none) return;
  if (action == ProblemAction::machine) return askMachine();
  docks_["readingDock"]->show();
  docks_["readingDock"]->raise();
  switch (action) {
    case ProblemAction::tool_table: return reading_->chooseTools();
    case ProblemAction::parameters: return reading_->chooseParameters();
    case ProblemAction::sub_folder: return reading_->chooseFolder();
    default: return reading_->focusArcTolerance();
  }
}

void MainWindow::usePreset(std::size_t index) {
  const ui::PlanPreset& preset = ui::plan_presets().at(index);
  workspace_.tuning().edit(preset.title(), "preset", [&](ui::Tuning& t) { preset.apply(t.options); });
}

/// The example says that it is one, until somebody has enough of that, and where there is room for it.
void MainWindow::showWelcome() {
  constexpr int kRoom = 740, kTouchRoom = 960;
  const auto& document = workspace_.document();
  const bool has_room = height() >= (preferences_.touch ? kTouchRoom : kRoom);
  welcome_->setVisible(has_room && document && document->path.isEmpty() && !preferences_.welcomed);
}

void MainWindow::tryOut(ui::WelcomeBar::Try what) {
  using Try = ui::WelcomeBar::Try;
  if (what == Try::open) return askProgram();
  if (what == Try::jerk) {
    auto* field = tuning_->findChild<ui::NumberField*>("jmEdit");
    tuning_->ensureWidgetVisible(field);
    return field->setFocus(Qt::OtherFocusReason);
  }
  workspace_.pin();
  usePreset(ui::plan_presets().size() - 1);
}

}  // namespace toolpace::studio
