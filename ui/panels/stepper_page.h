#pragma once
/// The page "Stepper": a pulse table, its intervals and step rate, and its export.

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "jobs/background.h"
#include "panels/figure_list.h"
#include "panels/form_grid.h"
#include "panels/number_field.h"
#include "theme/theme.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace::ui {

class PulsePlot;

class StepperPage : public QWidget {
  Q_OBJECT

 public:
  explicit StepperPage(QWidget* parent = nullptr);

  void setMove(const StepperMove& move);
  const StepperMove& move() const { return move_; }
  /// The table on display; nothing while the form asks for one that cannot be made.
  const std::optional<PulseTable>& table() const { return table_; }
  void setTheme(const Theme& theme);

  /// Asked before a file is written; its error is shown instead.
  using OutputCheck = std::function<Result<void>(const QString& file)>;
  void setOutputCheck(OutputCheck check) { check_ = std::move(check); }

  /// Writes the table: .h as a C header, anything else as CSV. exported() follows.
  void exportTo(const QString& file);

 signals:
  void exported(const QString& file, bool done);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Entry {
    NumberField* field;
    QLabel* label;
  };
  enum Field : std::size_t { kSteps, kSpeed, kAcc, kDec, kTimer, kFields };

  void buildForm(class QVBoxLayout* column);
  void buildExport(class QVBoxLayout* column);
  Entry makeEntry(Field field, const char* name, const DisplayUnit& unit, const NumberField::Range& range);
  void take(Field field, double value);
  void showForm();
  void update();
  void showFigures();
  void chooseFile();
  void setBusy(bool busy);
  void finishExport(const QString& file, const Result<void>& written);
  void retranslate();

  StepperMove move_{20000, 20000, 0.25, 0.15, 84e6};
  std::optional<PulseTable> table_;
  OutputCheck check_ = [](const QString&) { return Result<void>(); };
  FormGrid* grid_;
  std::array<Entry, kFields> entries_ = {};
  FigureList* figures_;
  QLabel* verdict_;
  QPushButton *export_, *cancel_;
  QProgressBar* progress_;
  PulsePlot* plot_;
  Background background_;
};

}  // namespace toolpace::ui
