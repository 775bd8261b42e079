#pragma once
/// Tables of names and figures: the first column takes the room, the others are as wide as their figures.

#include <QColor>
#include <QTableWidget>

namespace toolpace::ui {

/// Sorts by its number, shows its text.
class NumberItem : public QTableWidgetItem {
 public:
  NumberItem(const QString& text, double value);
  bool operator<(const QTableWidgetItem& other) const override;

 private:
  double value_;
};

QTableWidget* figure_table(const char* name, int columns, QWidget* parent);
/// The first head to the left, those of figures to the right.
void set_heads(QTableWidget* table, const QStringList& heads);
/// A spot of a colour, before a name.
QPixmap colour_chip(const QColor& colour);

}  // namespace toolpace::ui
