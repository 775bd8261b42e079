#pragma once
/// Table of what each NC line loses against its programmed feed.

#include <QAbstractTableModel>
#include <memory>

#include "models/timeline.h"
#include "models/units.h"

namespace toolpace::ui {

class LossModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kLine, kAsked, kMean, kTime, kLoss, kColumns };
  static constexpr int kSortRole = Qt::UserRole;  ///< the plain number of a cell

  using QAbstractTableModel::QAbstractTableModel;

  void setTimeline(std::shared_ptr<const Timeline> timeline);
  void setUnit(Units unit);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  double number(std::uint32_t line, int column) const;

  std::shared_ptr<const Timeline> timeline_;
  Units unit_;
};

}  // namespace toolpace::ui
