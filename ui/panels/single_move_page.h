#pragma once
/// The page "Single move": one move under one law, its figures and its curves.

#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "models/move_preview.h"
#include "panels/figure_list.h"
#include "panels/form_grid.h"
#include "panels/number_field.h"
#include "theme/theme.h"

namespace toolpace::ui {

class MovePlot;

class SingleMovePage : public QWidget {
  Q_OBJECT

 public:
  explicit SingleMovePage(QWidget* parent = nullptr);

  void setForm(const MoveForm& form);
  const MoveForm& form() const { return form_; }
  /// The move on display; nothing while the form asks for one that cannot be made.
  const std::optional<MovePreview>& preview() const { return preview_; }
  void setTheme(const Theme& theme);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// A number of the form.
  struct Entry {
    NumberField* field;
    QLabel* label;
    double* value;  ///< in form_
    MoveQuantity quantity;
    std::optional<LawParameter> parameter;  ///< shown only for laws that have it
  };

  QWidget* buildForm();
  FigureList* buildFigures();
  void addEntry(int row, int side, const char* name, double* value, MoveQuantity quantity,
                std::optional<LawParameter> parameter = {});
  void fillCombos();
  void showForm();
  void update();
  void showFigures();
  void showTrouble(const Error& error);
  void retranslate();

  MoveForm form_;
  std::optional<MovePreview> preview_;
  QComboBox *law_, *units_, *preset_;
  QLabel *law_label_, *units_label_, *preset_label_;
  FormGrid* grid_;
  std::vector<Entry> entries_;
  FigureList* figures_;
  QLabel* verdict_;
  MovePlot* plot_;
};

}  // namespace toolpace::ui
