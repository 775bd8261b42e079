#include "panels/stepper_page.h"

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>

#include "models/problem_model.h"
#include "models/pulse_preview.h"
#include "models/remedy_text.h"
#include "models/units.h"
#include "panels/pulse_plot.h"
#include "theme/control_name.h"
#include "toolpace/io/pulse_writer.h"

namespace toolpace::ui {
namespace {

constexpr int kStepperFormWidth = 300;
constexpr double kMostSteps = 1e9;
constexpr double kMillisecondsPerSecond = 1e3;
constexpr std::size_t kFigures = 6;

}  // namespace

StepperPage::StepperPage(QWidget* parent) : QWidget(parent), background_(this) {
  setObjectName("stepperPage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 8, 8, 8);
  row->setSpacing(16);
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  buildForm(column);
  buildExport(column);
  column->addStretch(1);
  row->addLayout(column);
  plot_ = new PulsePlot(this);
  row->addWidget(plot_, 1);
  setTheme(light_theme());
  retranslate();
  showForm();
  update();
}

StepperPage::Entry StepperPage::makeEntry(Field field, const char* name, const DisplayUnit& unit,
                                          const NumberField::Range& range) {
  auto* entry = new NumberField(name, name, Quantity::time, range, grid_);
  entry->setUnit(unit);
  connect(entry, &NumberField::edited, this, [this, field](double value) { take(field, value); });
  const Entry made{entry, grid_->add(static_cast<int>(field), 0, entry)};
  return made;
}

void StepperPage::setTheme(const Theme& theme) { plot_->setTheme(theme); }

void StepperPage::buildForm(QVBoxLayout* column) {
  grid_ = new FormGrid(this);
  grid_->setMinimumWidth(kStepperFormWidth);
  entries_[kSteps] = makeEntry(kSteps, "stepperSteps", {1.0, {}}, {1.0, kMostSteps, false, true});
  entries_[kSpeed] = makeEntry(kSpeed, "stepperSpeed", {1.0, {}}, {1e-6, 1e9});
  entries_[kAcc] = makeEntry(kAcc, "stepperTacc", {kMillisecondsPerSecond, "ms"}, {1e-9, 1e6});
  entries_[kDec] = makeEntry(kDec, "stepperTdec", {kMillisecondsPerSecond, "ms"}, {1e-9, 1e6});
  entries_[kTimer] = makeEntry(kTimer, "stepperTimer", {1.0, "Hz"}, {1.0, 1e12});
  column->addWidget(grid_);
  verdict_ = new QLabel(this);
  verdict_->setObjectName("stepperVerdict");
  verdict_->setWordWrap(true);
  column->addWidget(verdict_);
  figures_ = new FigureList(this);
  figures_->setMinimumWidth(kStepperFormWidth);
  for (std::size_t i = 0; i < kFigures; ++i) figures_->add(QString("stepperResult%1").arg(i));
  column->addWidget(figures_);
}

void StepperPage::buildExport(QVBoxLayout* column) {
  export_ = new QPushButton(this);
  export_->setObjectName("stepperExport");
  cancel_ = new QPushButton(this);
  cancel_->setObjectName("stepperCancel");
  progress_ = new QProgressBar(this);
  progress_->setObjectName("stepperProgress");
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(export_);
  row->addWidget(cancel_);
  row->addWidget(progress_, 1);
  column->addLayout(row);
  setBusy(false);
  connect(export_, &QPushButton::clicked, this, &StepperPage::chooseFile);
  connect(cancel_, &QPushButton::clicked, this, [this] { background_.cancel(); });
  connect(&background_, &Background::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(fraction * 1000)); });
  connect(&background_, &Background::finished, this, [this] { setBusy(false); });
}

void StepperPage::take(Field field, double value) {
  switch (field) {
    case kSteps: move_.steps = static_cast<std::uint64_t>(value); break;
    case kSpeed: move_.speed = value; break;
    case kAcc: move_.t_acc = value; break;
    case kDec: move_.t_dec = value; break;
    case kTimer: move_.timer_hz = value; break;
    case kFields: break;
  }
  update();
}

void StepperPage::setMove(const StepperMove& move) {
  move_ = move;
  showForm();
  update();
}

void StepperPage::showForm() {
  const std::array<double, kFields> values{static_cast<double>(move_.steps), move_.speed, move_.t_acc, move_.t_dec,
                                           move_.timer_hz};
  for (std::size_t i = 0; i < kFields; ++i) entries_[i].field->setValue(values[i]);
}

void StepperPage::update() {
  const auto table = PulseTable::create(move_);
  if (!table) {
    table_.reset();
    set_role(verdict_, "error");
    const QString remedy = remedy_text(table.error().remedy);
    verdict_->setText(message_text(table.error().code, table.error().message) + "\n" + remedy);
  } else {
    table_ = *table;
    set_role(verdict_, "good");
    verdict_->setText(table->reaches_speed() ? tr("The top speed is reached.") : tr("The top speed is not reached."));
  }
  export_->setEnabled(table_.has_value() && !background_.isBusy());
  showFigures();
}

void StepperPage::showFigures() {
  const PulsePreview preview = table_ ? preview_pulses(*table_) : PulsePreview{};
  plot_->setPreview(preview);
  std::array<QString, kFigures> texts;
  texts.fill("–");
  if (table_) {
    texts = {number_text(table_->peak_speed(), 8),
             number_text(table_->total_time(), 8),
             number_text(static_cast<double>(table_->total_ticks()), 15),
             number_text(preview.interval.front(), 12),
             number_text(*std::min_element(preview.interval.begin(), preview.interval.end()), 12),
             number_text(preview.interval.back(), 12)};
  }
  for (std::size_t i = 0; i < kFigures; ++i) figures_->setValue(i, texts[i]);
}

void StepperPage::chooseFile() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export the pulse table"), "pulses.csv",
                                                    tr("Comma-separated (*.csv);;C header (*.h)"));
  if (!file.isEmpty()) exportTo(file);
}

void StepperPage::exportTo(const QString& file) {
  if (!table_ || background_.isBusy()) return;
  if (const auto fine = check_(file); !fine) return finishExport(file, fine);
  setBusy(true);
  const PulseFormat format = file.endsWith(".h", Qt::CaseInsensitive) ? PulseFormat::c_header : PulseFormat::csv;
  const auto write = [this, file, format, table = *table_](const Monitor& monitor) {
    auto written = std::make_shared<Result<void>>(
        write_pulses(std::filesystem::path(file.toStdU16String()), table, format, monitor));
    return [this, file, written] { finishExport(file, *written); };
  };
  background_.start(write, [this, file](const Error& error) { finishExport(file, tl::unexpected(error)); });
}

void StepperPage::finishExport(const QString& file, const Result<void>& written) {
  set_role(verdict_, written ? "good" : "error");
  verdict_->setText(written ? tr("Written: %1").arg(file)
                            : message_text(written.error().code, written.error().message));
  emit exported(file, written.has_value());
}

void StepperPage::setBusy(bool busy) {
  export_->setEnabled(!busy && table_.has_value());
  cancel_->setVisible(busy);
  progress_->setVisible(busy);
  progress_->setValue(0);
}

void StepperPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    update();
  }
  QWidget::changeEvent(event);
}

void StepperPage::retranslate() {
  const std::array labels{tr("Steps"), tr("Top speed"), tr("Tacc"), tr("Tdec"), tr("Timer clock")};
  const std::array names{tr("Number of steps"), tr("Top speed"), tr("Acceleration time"), tr("Deceleration time"),
                         tr("Timer clock")};
  for (std::size_t i = 0; i < kFields; ++i) {
    entries_[i].label->setText(labels[i]);
    name_control(entries_[i].field, names[i]);
  }
  const std::array figures{tr("peak rate"),      tr("total time"),        tr("total ticks"),
                           tr("first interval"), tr("shortest interval"), tr("last interval")};
  const std::array units{tr("step/s"), tr("s"), tr("ticks"), tr("ticks"), tr("ticks"), tr("ticks")};
  for (std::size_t i = 0; i < kFigures; ++i) {
    figures_->setName(i, figures[i]);
    figures_->setUnit(i, units[i]);
  }
  entries_[kSteps].field->setUnit({1.0, tr("steps")});
  entries_[kSpeed].field->setUnit({1.0, tr("step/s")});
  export_->setText(tr("Export…"));
  name_control(export_, tr("Write the intervals as CSV or as a C header"));
  cancel_->setText(tr("Cancel"));
  name_control(cancel_, tr("Stop the export"));
  progress_->setAccessibleName(tr("Progress of the export"));
  plot_->retranslate();
}

}  // namespace toolpace::ui
