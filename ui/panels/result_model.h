#pragma once
/// The figures of plan A, of the pinned plan B, and their difference.

#include <QAbstractTableModel>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "drawing/planned.h"
#include "jobs/proof_service.h"
#include "models/setting_differences.h"
#include "models/units.h"
#include "theme/theme.h"

namespace toolpace::ui {

class ResultModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTitle, kPlanA, kPlanB, kDelta, kColumns };

  explicit ResultModel(QObject* parent = nullptr);

  void setPlans(const Planned& a, const Planned& b);
  /// Why figures of plan A that come from its proof are not there.
  void setProofState(ProofService::State state);
  void setUnit(Units unit);
  void setTheme(const Theme& theme);
  void retranslate();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// True for a row that says nothing: zero in every plan.
  bool isIdle(int row) const;
  /// Below the figures: in which settings A and B differ. The text of such a row stands for all its columns.
  bool isSetting(int row) const { return row >= static_cast<int>(rows_.size()); }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// quantity: in its unit; error: in µm or mil; share: in percent.
  enum class Shown { quantity, count, error, share };
  struct Row {
    QString title, tip;
    Quantity quantity;
    bool less_is_better;
    Shown shown;
    std::function<double(const Planned&)> read;  ///< NaN = not known
    bool may_be_hidden = false;                  ///< where it is zero
  };

  void addTimes();
  void addPeaks();
  void addProven();
  void addSizes();
  DisplayUnit unit_of(const Row& row) const;
  QString text_of(const Row& row, double value) const;
  QString difference(const Row& row, double a, double b) const;
  QString missing(bool is_a) const;
  QString tipOf(const Row& row, int column) const;

  void compareSettings();
  QVariant settingData(int row, int column, int role) const;

  std::vector<Row> rows_;
  std::vector<SettingDifference> differences_;
  Planned a_, b_;
  ProofService::State proof_state_ = ProofService::State::idle;
  Units unit_;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
