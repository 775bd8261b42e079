/// What a right button asks for: menus of the text, the preview, the plots and the results.

#include <QApplication>
#include <QClipboard>
#include <QMenu>

#include "main_window.h"
#include "models/units.h"
#include "panels/nc_panel.h"
#include "panels/results_panel.h"
#include "plots/profile_view.h"
#include "preview/contour_view.h"

namespace toolpace::studio {

void MainWindow::connectMenus() {
  profile_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(profile_, &QWidget::customContextMenuRequested, this, &MainWindow::showPlotMenu);
  nc_->view().setContextMenuPolicy(Qt::CustomContextMenu);
  connect(&nc_->view(), &QWidget::customContextMenuRequested, this, &MainWindow::showProgramMenu);
  connect(&contour_->canvas(), &ui::ContourCanvas::menuRequested, this, &MainWindow::showPreviewMenu);
  connect(results_, &ui::ResultsPanel::menuRequested, this, &MainWindow::showResultMenu);
}

void MainWindow::showPlotMenu(const QPoint& at) {
  const auto time = profile_->timeAt(at);
  if (!time) return;
  QMenu menu(this);
  menu.setObjectName("plotMenu");
  menu.addAction(tr("Feed hold here, at %1").arg(ui::duration_text(*time)), this, [this, time] { holdAt(time); })
      ->setObjectName("holdHereAction");
  menu.addActions({actions_->no_hold});
  menu.addSeparator();
  menu.addAction(tr("Cursor here"), this, [this, time] { workspace_.setCursorTime(*time); });
  menu.addActions({actions_->fit, actions_->hold_heights, actions_->export_plots});
  menu.exec(profile_->mapToGlobal(at));
}

void MainWindow::showProgramMenu(const QPoint& at) {
  ui::NcView& view = nc_->view();
  if (!view.document()) return;
  view.commitEdit();
  if (const int line = view.lineAt(at.y()); !view.isSelected(line)) view.setCurrentLine(line);
  QMenu menu(this);
  menu.setObjectName("programMenu");
  menu.addAction(tr("Cursor here"), this,
                 [this, &view] { workspace_.setCursorLine(static_cast<std::uint32_t>(view.currentLine())); });
  menu.addSeparator();
  menu.addAction(tr("Copy the lines"), this, [&view] { view.copySelection(); })->setObjectName("copyLinesAction");
  menu.addActions({actions_->edit_line, actions_->insert_line, actions_->delete_lines});
  menu.addSeparator();
  menu.addActions({actions_->find, actions_->go_to, actions_->next_problem, actions_->slowest_place});
  menu.exec(view.viewport()->mapToGlobal(at));
}

void MainWindow::showPreviewMenu(const QPoint& at) {
  QMenu menu(this);
  menu.setObjectName("previewMenu");
  if (const auto time = contour_->canvas().timeAt(at)) {
    menu.addAction(tr("Cursor here"), this, [this, time] { workspace_.setCursorTime(*time); });
    menu.addAction(tr("Feed hold here, at %1").arg(ui::duration_text(*time)), this, [this, time] { holdAt(time); });
    menu.addSeparator();
  }
  Actions& a = *actions_;
  menu.addActions({a.fit, a.rapids, a.view_xy, a.view_xz, a.view_yz, a.view_zx, a.view_iso});
  menu.addSeparator();
  menu.addActions({a.export_picture});
  menu.exec(contour_->canvas().mapToGlobal(at));
}

void MainWindow::showResultMenu(const QPoint& global) {
  QMenu menu(this);
  menu.setObjectName("resultMenu");
  menu.addAction(tr("Copy the results"), this, [this] { QApplication::clipboard()->setText(results_->text()); })
      ->setObjectName("copyResultsAction");
  menu.addSeparator();
  menu.addActions({actions_->pin, actions_->swap, actions_->unpin, actions_->export_report});
  menu.exec(global);
}

}  // namespace toolpace::studio
