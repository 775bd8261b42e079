#pragma once
/// The visible part of the plots as a table, for people who do not read curves, and for copying.

#include <QAbstractTableModel>

#include "drawing/profile_series.h"
#include "models/units.h"

namespace toolpace::ui {

class ValueTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTime, kDistance, kFirstTrack, kColumns = kFirstTrack + static_cast<int>(kMotionTrackCount) };
  static constexpr int kRows = 101;  ///< evenly over the visible time

  using QAbstractTableModel::QAbstractTableModel;

  void setSeries(std::shared_ptr<const ProfileSeries> series);
  void setRange(double begin, double end);  ///< [s]
  void setUnit(Units unit);
  double timeOf(int row) const;  ///< [s]
  /// All of it, columns separated by tabs, with a header; numbers in the C locale.
  QString text() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::shared_ptr<const ProfileSeries> series_;
  double begin_ = 0, end_ = 1;
  Units unit_;
};

}  // namespace toolpace::ui
