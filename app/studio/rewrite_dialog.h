#pragma once
/// The program written anew for a controller: with what, what comes of it, and where the gain is.

#include <QDialog>
#include <memory>
#include <vector>

#include "jobs/rewrite_service.h"
#include "models/controller_model.h"
#include "models/units.h"
#include "theme/theme.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace toolpace::ui {
class ContourCanvas;
class FormGrid;
class NumberField;
class SupplyFields;
}  // namespace toolpace::ui

namespace toolpace::studio {

/// What is asked for to begin with.
struct RewriteStart {
  std::shared_ptr<const ui::Document> document;
  ReadOptions read_options;
  Setup setup;
  ui::SharedControllerText controller;  ///< that the program runs on; null = Toolpace's own plan
  PredictOptions supply;                ///< how blocks come to it
  ui::Units units;
  ui::Theme theme;
};

/// Works as soon as it is shown, and again after each change. Accepted: found() is to be saved.
class RewriteDialog : public QDialog {
  Q_OBJECT

 public:
  RewriteDialog(RewriteStart start, QWidget* parent);
  ~RewriteDialog() override;

  /// Null while there is nothing to save.
  const std::shared_ptr<const ui::RewriteFound>& found() const { return found_; }
  bool isWorking() const { return service_.isRunning(); }

 private:
  QWidget* buildForm();
  void buildFields(ui::FormGrid& grid);
  QWidget* buildResults();
  void fillControllers();
  void chooseController();
  bool takeSettings(const QString& path);
  ui::RewriteRequest request() const;
  void work();
  void take(std::shared_ptr<const ui::RewriteFound> found);
  void showState();
  // rewrite_dialog_results.cpp
  void showFound();
  void fillSummary();
  void showPaths();
  void showRanges();
  void showNotes();
  void setEnlargement(int index);

  RewriteStart start_;
  ui::RewriteService service_;
  std::vector<std::pair<QString, ControllerSettings>> controllers_;  // to choose from
  int chosen_ = 0;                                                   // row of the list that counts
  QComboBox *controller_, *dialect_, *enlargement_;
  ui::NumberField* tolerance_;
  ui::SupplyFields* supply_;
  QCheckBox *arcs_, *feeds_;
  QTableWidget *summary_, *ranges_;
  QLabel *notes_, *state_;
  QProgressBar* progress_;
  QPushButton *again_, *save_;
  ui::ContourCanvas* canvas_;
  std::shared_ptr<const ui::RewriteFound> found_;
  QString trouble_;
};

}  // namespace toolpace::studio
