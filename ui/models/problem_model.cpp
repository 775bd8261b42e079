#include "models/problem_model.h"

#include <algorithm>

#include "models/remedy_text.h"
#include "theme/icons.h"

namespace toolpace::ui {
namespace {

QIcon icon_of(Severity severity, const Theme& theme) {
  Theme tint = theme;
  tint.text = severity == Severity::error     ? theme.error
              : severity == Severity::warning ? theme.warning
                                              : theme.secondary;
  return icon(severity == Severity::error ? "error" : "warning", tint);
}

}  // namespace

ProblemModel::ProblemModel(QObject* parent) : QAbstractTableModel(parent) { setTheme(light_theme()); }

void ProblemModel::setProblems(Diagnostics problems) {
  beginResetModel();
  problems_ = std::move(problems);
  endResetModel();
}

void ProblemModel::setTheme(const Theme& theme) {
  beginResetModel();
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
    icons_.at(static_cast<std::size_t>(severity)) = icon_of(severity, theme);
  }
  endResetModel();
}

int ProblemModel::count(Severity severity) const {
  return static_cast<int>(
      std::count_if(problems_.begin(), problems_.end(), [severity](const auto& p) { return p.severity == severity; }));
}

int ProblemModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(problems_.size());
}

int ProblemModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ProblemModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Diagnostic& problem = at(index.row());
  if (role == Qt::DecorationRole && index.column() == kPlace) {
    return icons_.at(static_cast<std::size_t>(problem.severity));
  }
  const QString message = message_text(problem.code, problem.message);
  const QString remedy = remedy_text(problem.remedy);
  if (role == kRemedyRole) return remedy;
  if (role == Qt::ToolTipRole) {
    return remedy.isEmpty() ? message : message + "\n" + remedy;
  }
  if (role != Qt::DisplayRole) return {};
  if (index.column() == kAction) return {};
  if (index.column() == kMessage) return message;
  if (problem.where.line == 0) return "–";
  return problem.where.column == 0 ? QString::number(problem.where.line)
                                   : QString("%1:%2").arg(problem.where.line).arg(problem.where.column);
}

QVariant ProblemModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return section == kPlace ? tr("Line") : section == kMessage ? tr("Message") : QString();
}

}  // namespace toolpace::ui
