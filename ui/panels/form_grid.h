#pragma once
/// Rows of label, field and unit, aligned.

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>
#include <initializer_list>
#include <vector>

#include "panels/number_field.h"

namespace toolpace::ui {

/// Labels left, values right-aligned, units in the secondary colour. Two pairs fit side by side. Wide rows have a grid
/// of their own, so that their longer labels take no room from the pairs.
class FormGrid : public QWidget {
  Q_OBJECT

 public:
  explicit FormGrid(QWidget* parent = nullptr);

  /// Adds label, field and unit at a row. `side` 0 = left, 1 = right half.
  QLabel* add(int row, int side, NumberField* field);
  /// Adds a label and a widget that fills the rest of the row.
  QLabel* addWide(int row, QWidget* widget);
  void setRowVisible(QWidget* field, bool visible);
  /// What is of no use stays where it is, so that nothing else moves. @param reason  why it is of none; empty: it is of use
  void setRowUseless(QWidget* field, const QString& reason);

 private:
  struct Parts {
    QWidget* field;
    std::vector<QWidget*> others;
  };
  QGridLayout *pairs_ = nullptr, *wide_ = nullptr;
  QGridLayout* grid(bool wide);
  QVBoxLayout* column_;
  std::vector<Parts> parts_;
};

/// A label in the secondary colour.
QLabel* secondary_label(const QString& text, QWidget* parent = nullptr);

/// Label, field and unit that stay together.
QWidget* kept_together(std::initializer_list<QWidget*> parts, QWidget* parent);

}  // namespace toolpace::ui
