#include "export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include "models/units.h"
#include "theme/control_name.h"
#include "toolpace/base/axes.h"
#include "toolpace/io/setpoint_writer.h"
#include "toolpace/pipeline/sampled.h"

namespace toolpace::studio {
namespace {

constexpr std::size_t kMeasured = 4096;  // rows

[[maybe_unused]] constexpr const char* kTranslatedTitles[] = {
    QT_TRANSLATE_NOOP("formats", "Comma-separated"), QT_TRANSLATE_NOOP("formats", "NumPy array"),
    QT_TRANSLATE_NOOP("formats", "NumPy archive"), QT_TRANSLATE_NOOP("formats", "LinuxCNC halstreamer"),
    QT_TRANSLATE_NOOP("formats", "Semicolons")};

QString suffix_of(const SetpointFormat& format) {
  return QString::fromUtf8(format.suffix.data(), static_cast<qsizetype>(format.suffix.size()));
}


/// Bytes of the first rows as a file.
std::optional<double> size_of(const Outcome& outcome, const QString& file, const ui::ExportOptions& options,
                              std::size_t rows) {
  SetpointFileOptions format;
  format.axis_derivatives = options.axis_derivatives;
  format.decimal_comma = options.decimal_comma;
  format.program_name = outcome.job->program_name;
  auto writer = open_setpoint_writer(file.toStdString(), format);
  if (!writer) return std::nullopt;
  Sampler sampler = sampler_of(outcome);
  Setpoints chunk;
  if (!sampler.next(chunk, rows) || !(*writer)->write(chunk) || !(*writer)->finish()) return std::nullopt;
  return static_cast<double>(QFileInfo(file).size());
}

QString size_text(double bytes) {
  if (bytes < 1e6) return ui::number_text(bytes / 1e3, 2) + " kB";
  return bytes < 1e9 ? ui::number_text(bytes / 1e6, 2) + " MB" : ui::number_text(bytes / 1e9, 2) + " GB";
}

}  // namespace

QString format_title(const SetpointFormat& format) { return QCoreApplication::translate("formats", format.title); }

std::optional<double> about_size(const Outcome& outcome, const QString& suffix, const ui::ExportOptions& options) {
  const QTemporaryDir folder;
  if (!folder.isValid()) return std::nullopt;
  const std::size_t rows = sampler_of(outcome).rows(), some = std::min(kMeasured, rows), few = (some + 1) / 2;
  const auto all = size_of(outcome, folder.filePath("all" + suffix), options, some);
  const auto half = size_of(outcome, folder.filePath("half" + suffix), options, few);
  if (!all || !half) return std::nullopt;
  if (some == rows || some == few) return all;
  const double each = (*all - *half) / static_cast<double>(some - few);  // what stands at the head is written once
  return *all + each * static_cast<double>(rows - some);
}

ExportDialog::ExportDialog(std::shared_ptr<const Outcome> outcome, const ui::ExportOptions& options, QWidget* parent)
    : QDialog(parent),
      outcome_(std::move(outcome)),
      options_(options),
      format_(new QComboBox(this)),
      derivatives_(new QCheckBox(this)),
      comma_(new QCheckBox(this)),
      contents_(new QLabel(this)) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Save setpoints"));
  for (const SetpointFormat& format : setpoint_formats()) {
    format_->addItem(format_title(format) + "  " + suffix_of(format), suffix_of(format));
  }
  format_->setObjectName("exportFormat");
  ui::name_control(format_, tr("Format"), tr("How the setpoints are written"));
  derivatives_->setObjectName("exportDerivatives");
  derivatives_->setText(tr("with v, a, j of each axis"));
  derivatives_->setChecked(options.axis_derivatives);
  ui::name_control(derivatives_, derivatives_->text(),
                   tr("Differences of the positions, as a check of them would take"));
  comma_->setObjectName("exportComma");
  comma_->setText(tr("decimal comma"));
  comma_->setChecked(options.decimal_comma);
  ui::name_control(comma_, comma_->text(), tr("For spreadsheets that expect 1,5 instead of 1.5"));
  contents_->setObjectName("exportContents");
  contents_->setWordWrap(true);
  contents_->setMinimumWidth(360);
  auto* buttons = new QDialogButtonBox(this);
  auto* save = buttons->addButton(tr("Save as…"), QDialogButtonBox::AcceptRole);
  save->setObjectName("exportSave");
  auto* cancel = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  cancel->setObjectName("exportCancel");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout;
  form->addRow(tr("Format"), format_);
  form->addRow({}, derivatives_);
  form->addRow({}, comma_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(contents_);
  column->addWidget(buttons);
  connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::showContents);
  connect(derivatives_, &QCheckBox::toggled, this, &ExportDialog::showContents);
  connect(comma_, &QCheckBox::toggled, this, &ExportDialog::showContents);
  showContents();
}

QString ExportDialog::suffix() const { return format_->currentData().toString(); }

ui::ExportOptions ExportDialog::options() const {
  ui::ExportOptions options = options_;
  options.axis_derivatives = derivatives_->isChecked();
  options.decimal_comma = comma_->isChecked();
  return options;
}

void ExportDialog::showContents() {
  derivatives_->setEnabled(suffix() != ".halstream");
  comma_->setEnabled(suffix() == ".semicolon.csv");
  const std::size_t rows = sampler_of(*outcome_).rows();
  Sampler sampler = sampler_of(*outcome_);
  Setpoints first;
  (void)sampler.next(first, 1);
  QString text =
      tr("%1 setpoints, one each %2 ms, over %3.")
          .arg(ui::number_text(static_cast<double>(rows), 12), ui::number_text(outcome_->job->machine.period * 1e3, 6),
               ui::duration_text(outcome_->plan.cycle_time()));
  const auto size = about_size(*outcome_, suffix(), options());
  text += "\n" +
          (size ? tr("The file takes about %1.").arg(size_text(*size)) : tr("How large the file gets is not known."));
  contents_->setText(text);
}

}  // namespace toolpace::studio
