#pragma once
/// The figures of plan A, of the pinned plan B, and their difference.

#include <QAbstractTableModel>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "jobs/planned.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

class ResultModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTitle, kPlanA, kPlanB, kDelta, kColumns };

  explicit ResultModel(QObject* parent = nullptr);

  void setPlans(const Planned& a, const Planned& b);
  void setUnit(LengthUnit unit);
  void setTheme(const Theme& theme);
  void retranslate();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    QString title;
    Quantity quantity;
    bool less_is_better;
    bool is_count;
    std::function<double(const Planned&)> read;  ///< NaN = not known
    bool is_error = false;                       ///< shown in µm or mil
  };

  DisplayUnit unit_of(const Row& row) const;
  QString shown(const Row& row, double value) const;
  QString difference(const Row& row, double a, double b) const;

  std::vector<Row> rows_;
  Planned a_, b_;
  LengthUnit unit_ = LengthUnit::mm;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
