#include "panels/calm_panel.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <limits>

#include "models/option_names.h"
#include "models/problem_model.h"
#include "models/setting_differences.h"
#include "panels/figure_table.h"
#include "panels/form_grid.h"
#include "theme/control_name.h"
#include "theme/flow_layout.h"
#include "toolpace/sample/shaper.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastResidual = 1e-6, kWidestResidual = 10;  // [mm]
constexpr int kLeastTableHeight = 120;                         // px
enum CalmColumn { kCalmTitle, kCalmLeaves, kCalmCosts, kCalmColumns };

QString title_of(const CalmChoice& choice) {
  switch (choice.by) {
    case CalmBy::five_phase: return CalmPanel::tr("Five-phase ramps");
    case CalmBy::seven_phase: return CalmPanel::tr("Seven-phase ramps");
    case CalmBy::quintic: return CalmPanel::tr("Quintic ramps");
    case CalmBy::shaper: return CalmPanel::tr("Shaper %1").arg(shaper_title(choice.job->options.shaper));
    case CalmBy::nothing: break;
  }
  return CalmPanel::tr("As it is");
}

}  // namespace

CalmPanel::CalmPanel(TuningModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      title_(new QLabel(this)),
      modes_(new QLabel(this)),
      shaper_label_(new QLabel(this)),
      limit_label_(new QLabel(this)),
      limit_unit_(secondary_label({}, this)),
      hint_(new QLabel(this)),
      shaper_(new QComboBox(this)),
      limit_(new NumberField("calmLimit", {}, Quantity::length, {kLeastResidual, kWidestResidual, true}, this)),
      button_(new QPushButton(this)),
      table_(figure_table("calmTable", kCalmColumns, this)) {
  setObjectName("calmPanel");
  title_->setProperty("role", "heading");
  modes_->setObjectName("calmModes");
  modes_->setWordWrap(true);
  shaper_->setObjectName("shaperBox");
  for (const ShaperKind kind : kShaperKinds) shaper_->addItem({}, static_cast<int>(kind));
  limit_->setValue(std::numeric_limits<double>::infinity());
  button_->setObjectName("calmButton");
  hint_->setObjectName("calmHint");
  hint_->setProperty("role", "secondary");
  hint_->setWordWrap(true);
  table_->setMinimumHeight(kLeastTableHeight);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(title_);
  column->addWidget(modes_);
  auto* head = new QWidget(this);
  auto* row = new FlowLayout(head);
  row->setSpacing(8);
  row->addWidget(kept_together({shaper_label_, shaper_}, head));
  row->addWidget(kept_together({limit_label_, limit_, limit_unit_}, head));
  row->addWidget(button_);
  column->addWidget(head);
  column->addWidget(table_, 1);
  column->addWidget(hint_);
  connectParts();
  setUnits(units_);
  showValues();
}

void CalmPanel::connectParts() {
  connect(shaper_, &QComboBox::activated, this, [this](int index) {
    const auto kind = static_cast<ShaperKind>(shaper_->itemData(index).toInt());
    model_.edit(tr("Shaper"), "shaper", [kind](Tuning& t) { t.options.shaper = kind; });
  });
  connect(&model_, &TuningModel::changed, this, &CalmPanel::showValues);
  connect(button_, &QPushButton::clicked, this, [this] { isAdvising() ? service_.cancel() : advise(); });
  connect(table_, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) { take(item->row()); });
  connect(limit_, &NumberField::unitChanged, this, [this] { limit_unit_->setText(limit_->unitText()); });
  connect(&service_, &TuneService::advised, this, [this](const VibrationAdvice& advice) {
    advice_ = advice;
    fill();
  });
  connect(&service_, &TuneService::progressed, this,
          [this](double fraction) { hint_->setText(tr("planning… %1 %").arg(static_cast<int>(fraction * 100))); });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { trouble_ = message_text(error.code, error.message); });
  connect(&service_, &TuneService::finished, this, [this] {
    showState();
    emit advised();
  });
}

std::shared_ptr<const Job> CalmPanel::present() const {
  if (!job_) return nullptr;
  auto job = std::make_shared<Job>(*job_);
  job->machine = model_.value().machine;
  job->options = model_.value().options;
  job->refined = true;
  return job;
}

void CalmPanel::setJob(std::shared_ptr<const Job> job) {
  if ((job ? job->program : nullptr) != (job_ ? job_->program : nullptr)) {
    service_.cancel();
    advice_.reset();
    fill();
  }
  job_ = std::move(job);
  showState();
}

void CalmPanel::advise() {
  asked_ = present();
  if (!asked_) return;
  trouble_.clear();
  service_.advise(asked_, std::isfinite(limit_->value()) ? std::optional(limit_->value()) : std::nullopt);
  showState();
}

void CalmPanel::showValues() {
  const QSignalBlocker quiet(shaper_);
  shaper_->setCurrentIndex(shaper_->findData(static_cast<int>(model_.value().options.shaper)));
  QStringList texts;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto modes = modes_of(model_.value().machine.servo[axis]);
    if (!modes.empty()) texts << QString("%1: %2").arg(QLatin1Char(kAxisNames[axis])).arg(modes_text(modes));
  }
  modes_->setText(texts.isEmpty() ? tr("No axis has a mode: give a resonance above, or read them from an accelerometer "
                                       "with toolpace identify")
                                  : texts.join("\n"));
  shaper_->setEnabled(!texts.isEmpty());
  showState();
}

void CalmPanel::fill() {
  table_->setRowCount(0);
  const DisplayUnit unit = error_unit(units_);
  const std::size_t rows = advice_ ? advice_->choices.size() : 0;
  table_->setRowCount(static_cast<int>(rows));
  for (std::size_t i = 0; i < rows; ++i) {
    const CalmChoice& choice = advice_->choices[i];
    QStringList words;
    for (const SettingDifference& d : setting_differences(*advice_->present.job, *choice.job, units_))
      words << QString("%1: %2 → %3").arg(d.title, d.a, d.b);
    auto* title = new QTableWidgetItem(title_of(choice));
    title->setToolTip(words.join('\n'));
    QFont font = table_->font();
    font.setBold(advice_->best == i);
    title->setFont(font);
    const double costs = choice.cycle_time - advice_->present.cycle_time;
    const int row = static_cast<int>(i);
    table_->setItem(row, kCalmTitle, title);
    table_->setItem(row, kCalmLeaves, new NumberItem(error_text(choice.residual, unit), choice.residual));
    table_->setItem(row, kCalmCosts, new NumberItem(QString::number(costs, 'f', 3), costs));
  }
  showState();
}

void CalmPanel::showState() {
  button_->setText(isAdvising() ? tr("Cancel") : tr("What helps"));
  name_control(
      button_, button_->text(),
      tr("Plan with the ramp times and jerks that suit the modes, and with each shaper, and measure what is left"));
  button_->setEnabled(isAdvising() || (job_ && shaper_->isEnabled()));
  if (isAdvising()) return;
  if (!trouble_.isEmpty()) return hint_->setText(trouble_);
  if (!advice_) return hint_->setText(tr("What each way of keeping calm leaves after stops, and what it costs"));
  const DisplayUnit unit = error_unit(units_);
  const auto text = [&](double residual) { return error_text(residual, unit) + " " + unit.text; };
  const QString now = tr("Now %1 after stops.").arg(text(advice_->present.residual));
  hint_->setText(now + " " + tr("Double click or Enter takes one."));
}

void CalmPanel::take(int row) {
  if (isAdvising() || !advice_) return;
  const Job& job = *advice_->choices[static_cast<std::size_t>(row)].job;
  model_.edit(tr("Keeping calm"), "calm", [&](Tuning& t) {
    t.machine.path = job.machine.path;
    t.options = job.options;
  });
}

void CalmPanel::setUnits(Units units) {
  units_ = units;
  limit_->setUnit(error_unit(units));
  limit_unit_->setText(limit_->unitText());
  retranslate();
}

void CalmPanel::retranslate() {
  title_->setText(tr("Vibration"));
  shaper_label_->setText(tr("Shaper"));
  name_control(shaper_, tr("Shaper"),
               tr("Setpoints become means of planned ones, so that every mode of every axis comes to rest; corners and "
                  "curves are rounded"));
  for (int i = 0; i < shaper_->count(); ++i)
    shaper_->setItemText(i, shaper_title(static_cast<ShaperKind>(shaper_->itemData(i).toInt())));
  limit_label_->setText(tr("Residual ≤"));
  limit_->setUnlimitedText(tr("least"));
  name_control(limit_, tr("Largest residual"), tr("What a stop may leave of a vibration; empty: as little as can be"));
  set_heads(table_, {tr("By"), tr("Leaves") + "  " + error_unit(units_).text, tr("Costs") + "  s"});
  name_control(table_, tr("What keeps the machine calm, what it leaves and costs"),
               tr("Double click or Enter takes one"));
  showValues();
  fill();
}

}  // namespace toolpace::ui
