#pragma once
/// What will be written of a plan, and about how large it will be, before a file is named.

#include <QDialog>
#include <memory>
#include <optional>

#include "jobs/setpoint_export.h"
#include "toolpace/io/setpoint_format.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace toolpace::studio {

class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(std::shared_ptr<const Outcome> outcome, const ui::ExportOptions& options, QWidget* parent);

  QString suffix() const;  ///< of the chosen format: ".csv"
  ui::ExportOptions options() const;

 private:
  void showContents();

  std::shared_ptr<const Outcome> outcome_;
  ui::ExportOptions options_;
  QComboBox* format_;
  QCheckBox *derivatives_, *comma_;
  QLabel* contents_;
};

/// "Comma-separated", in the language of the window.
QString format_title(const SetpointFormat& format);

/// About how many bytes a plan's setpoints take in a format: its first rows are written to a file and measured. Nothing where
/// that fails.
std::optional<double> about_size(const Outcome& outcome, const QString& suffix, const ui::ExportOptions& options);

}  // namespace toolpace::studio
