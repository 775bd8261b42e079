#pragma once
/// A column of named figures with their units, and a verdict above or below it.

#include <QLabel>
#include <QWidget>
#include <vector>

namespace toolpace::ui {

/// Names left, values right-aligned and selectable, units in the secondary colour.
class FigureList : public QWidget {
  Q_OBJECT

 public:
  explicit FigureList(QWidget* parent = nullptr);

  /// Adds a row whose value carries this object name.
  void add(const QString& object_name);
  std::size_t size() const { return rows_.size(); }
  void setName(std::size_t row, const QString& name);  ///< also what the value is called for those who do not see it
  void setTip(std::size_t row, const QString& tip) { rows_.at(row).value->setToolTip(tip); }
  void setValue(std::size_t row, const QString& value) { rows_.at(row).value->setText(value); }
  void setUnit(std::size_t row, const QString& unit) { rows_.at(row).unit->setText(unit); }

 private:
  struct Row {
    QLabel *name, *value, *unit;
  };
  std::vector<Row> rows_;
};

/// Colours a label by its role: "good", "error", "secondary".
void set_role(QLabel* label, const char* role);

}  // namespace toolpace::ui
