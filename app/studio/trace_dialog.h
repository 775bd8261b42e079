#pragma once
/// What the columns of a trace mean: guessed, and corrected by a person.

#include <QDialog>
#include <vector>

#include "toolpace/trace/trace_file.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace toolpace::ui {
class NumberField;
}

namespace toolpace::studio {

class TraceDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param name  of the file, for people
  TraceDialog(const QString& name, TracePreview preview, QWidget* parent);

  /// How the trace is to be read.
  TraceOptions options() const;

 private:
  struct Row {
    QComboBox *meaning, *unit;
  };
  void buildTable();
  void buildRow(int row);
  void fillUnits(int row, const std::string& unit);
  void showState();

  TracePreview preview_;
  QTableWidget* table_;
  ui::NumberField* step_;
  QLabel* state_;
  QPushButton* use_;
  std::vector<Row> rows_;
};

}  // namespace toolpace::studio
