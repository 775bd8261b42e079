#pragma once
/// Errors and warnings of the program and of its plan, as a table.

#include <QAbstractTableModel>
#include <QIcon>
#include <array>

#include "models/diagnostic_text.h"
#include "theme/theme.h"
#include "toolpace/base/result.h"

namespace toolpace::ui {

class ProblemModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kPlace, kMessage, kAction, kColumns };  ///< the last is for buttons

  static constexpr int kRemedyRole = Qt::UserRole;  ///< what to do about it, may be empty

  explicit ProblemModel(QObject* parent = nullptr);

  void setProblems(Diagnostics problems);
  void setTheme(const Theme& theme);
  const Diagnostic& at(int row) const { return problems_[static_cast<std::size_t>(row)]; }
  const Diagnostics& problems() const { return problems_; }
  int count(Severity severity) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  Diagnostics problems_;
  std::array<QIcon, 3> icons_;  ///< of each severity; drawing one takes longer than all else about a row
};

}  // namespace toolpace::ui
