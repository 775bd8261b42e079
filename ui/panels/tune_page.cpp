#include "panels/tune_page.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "models/problem_model.h"
#include "models/setting_differences.h"
#include "panels/figure_table.h"
#include "panels/form_grid.h"
#include "theme/control_name.h"
#include "theme/flow_layout.h"
#include "theme/role.h"

namespace toolpace::ui {
namespace {

constexpr double kUsualPlans = 200, kMostPlans = 100'000;
constexpr double kLeastLimit = 1e-5, kWidestLimit = 1e3;  // [mm]
constexpr int kBesideEachOther = 640;                     // px: below, the tables stand under the plot
enum SettingColumn { kSettingName, kSettingNow, kSettingThere, kSettingColumns };

}  // namespace

TunePage::TunePage(TuningModel& model, ControllerModel& controller, QWidget* parent)
    : QWidget(parent),
      model_(model),
      vary_(new VaryButton(this)),
      limit_label_(new QLabel(this)),
      limit_unit_(secondary_label({}, this)),
      vibration_label_(new QLabel(this)),
      vibration_unit_(secondary_label({}, this)),
      plans_label_(new QLabel(this)),
      verdict_(new QLabel(this)),
      changes_title_(new QLabel(this)),
      limit_(new NumberField("tuneContour", {}, Quantity::length, {kLeastLimit, kWidestLimit, true}, this)),
      vibration_(new NumberField("tuneVibration", {}, Quantity::length, {kLeastLimit, kWidestLimit, true}, this)),
      plans_(new NumberField("tunePlans", {}, Quantity::time, {1, kMostPlans, false, true}, this)),
      button_(new QPushButton(this)),
      plot_(new FrontPlot(this)),
      dial_(new FrontDial(this)),
      settings_(figure_table("tuneSettings", kSettingColumns, this)),
      changes_(new SingleChangesPanel(this)),
      of_controller_(new TuneSettingsPanel(controller, model, this)) {
  setObjectName("tunePage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  for (auto* limit : {limit_, vibration_}) limit->setValue(std::numeric_limits<double>::infinity());
  plans_->setUnit({1.0, {}});
  plans_->setValue(kUsualPlans);
  button_->setObjectName("tuneButton");
  verdict_->setObjectName("tuneVerdict");
  verdict_->setWordWrap(true);
  changes_title_->setObjectName("tuneChangesTitle");
  changes_title_->setProperty("role", "heading");
  build();
  connectParts();
  setUnits(units_);
  retranslate();
  showState();
}

QWidget* TunePage::buildHead() {
  auto* head = new QWidget(this);
  auto* row = new FlowLayout(head);
  row->setSpacing(8);
  row->addWidget(vary_);
  row->addWidget(kept_together({limit_label_, limit_, limit_unit_}, head));
  vibration_part_ = kept_together({vibration_label_, vibration_, vibration_unit_}, head);
  row->addWidget(vibration_part_);
  row->addWidget(kept_together({plans_label_, plans_}, head));
  row->addWidget(button_);
  row->addWidget(verdict_);
  return head;
}

QWidget* TunePage::buildRight() {
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(changes_title_);
  column->addWidget(settings_, 2);
  column->addSpacing(4);
  column->addWidget(changes_, 3);
  return right;
}

void TunePage::build() {
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(8, 8, 8, 8);
  of_plan_ = new QWidget(this);
  page->addWidget(of_plan_);
  page->addWidget(of_controller_);
  of_controller_->hide();
  auto* column = new QVBoxLayout(of_plan_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(buildHead());
  auto* left = new QWidget(this);
  auto* plot_column = new QVBoxLayout(left);
  plot_column->setContentsMargins(0, 0, 0, 0);
  plot_column->setSpacing(4);
  plot_column->addWidget(plot_, 1);
  plot_column->addWidget(dial_);
  body_ = new QBoxLayout(QBoxLayout::LeftToRight);
  body_->setSpacing(8);
  body_->addWidget(left, 1);
  body_->addWidget(buildRight(), 1);
  column->addLayout(body_, 1);
}

void TunePage::connectParts() {
  connect(button_, &QPushButton::clicked, this, [this] { isSearching() ? stop() : search(); });
  connect(&service_, &TuneService::tuned, this, [this](const toolpace::TuneResult& tuning) {
    tuning_ = std::make_shared<const toolpace::TuneResult>(tuning);
    look();
  });
  connect(&service_, &TuneService::progressed, this,
          [this](double fraction) { verdict_->setText(tr("searching… %1 %").arg(static_cast<int>(fraction * 100))); });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { trouble_ = message_text(error.code, error.message); });
  connect(&service_, &TuneService::finished, this, [this] {
    enough_.reset();
    showState();
    emit searched();
  });
  const auto take_point = [this](std::size_t index) {
    if (tuning_ && !stale_) take(tuning_->front[index].job);
  };
  connect(plot_, &FrontPlot::chosen, this, take_point);
  connect(plot_, &FrontPlot::hovered, this, [this](std::optional<std::size_t> index) {
    hovered_ = index;
    showChanges();
  });
  connect(dial_, &FrontDial::chosen, this, take_point);
  connect(dial_, &FrontDial::gestureStarted, &model_, &TuningModel::beginGesture);
  connect(dial_, &FrontDial::gestureFinished, &model_, &TuningModel::endGesture);
  connect(changes_, &SingleChangesPanel::chosen, this, &TunePage::take);
  connect(&model_, &TuningModel::changed, this, [this] {
    outdated_ = true;
    isVisible() ? look() : showState();
  });
  connect(limit_, &NumberField::unitChanged, this, [this] { limit_unit_->setText(limit_->unitText()); });
  connect(vibration_, &NumberField::unitChanged, this, [this] { vibration_unit_->setText(vibration_->unitText()); });
}

/// The program with the settings as they are now.
std::shared_ptr<const Job> TunePage::job() const {
  if (!plan_job_) return nullptr;
  auto job = std::make_shared<Job>(*plan_job_);
  job->machine = model_.value().machine;
  job->options = model_.value().options;
  job->refined = true;
  return job;
}

void TunePage::showPlans(const Planned& plan, const Planned&) {
  const auto job = plan ? plan.timeline->outcome()->job : nullptr;
  const auto program = job ? job->program : nullptr;
  plan_job_ = job;
  if (program == program_) return;
  program_ = program;
  outdated_ = true;
  if (isVisible()) look();
  showState();
}

void TunePage::showController(const ControllerView& view) {
  of_plan_->setVisible(view.chosen == nullptr);
  of_controller_->setVisible(view.chosen != nullptr);
  of_controller_->showController(view);
}

void TunePage::search() {
  if (!of_controller_->isHidden()) return of_controller_->search();
  const auto present = job();
  if (!present) return;
  TuneOptions options;
  options.turned = vary_->chosen();
  if (std::isfinite(limit_->value())) options.contour = limit_->value();
  if (shakes() && std::isfinite(vibration_->value())) options.vibration = vibration_->value();
  options.plans = static_cast<std::size_t>(plans_->value());
  enough_ = std::make_shared<std::atomic<bool>>(false);
  options.is_over = [enough = enough_] { return enough->load(); };
  trouble_.clear();
  service_.search(present, options);
  showState();
}

/// Whether an axis has a mode.
bool TunePage::shakes() const {
  const auto& servo = model_.value().machine.servo;
  return !std::all_of(servo.begin(), servo.end(), is_stiff);
}

/// Asked once, the search ends with what it has; asked again, it leaves that, too.
void TunePage::stop() {
  if (enough_ && !enough_->load()) {
    enough_->store(true);
  } else {
    service_.cancel();
  }
  showState();
}

void TunePage::take(const std::shared_ptr<const Job>& job) {
  model_.edit(tr("Best settings"), "tune", [&](ui::Tuning& t) {
    t.machine = job->machine;
    t.options = job->options;
  });
}

/// Finds the settings in use among those that were found.
void TunePage::look() {
  outdated_ = false;
  const auto present = job();
  used_.reset();
  bool as_before = false;
  if (tuning_ && present) {
    as_before = has_same_settings(*tuning_->present.job, *present);
    for (std::size_t i = 0; i < tuning_->front.size() && !used_; ++i) {
      if (has_same_settings(*tuning_->front[i].job, *present)) used_ = i;
    }
  }
  stale_ = tuning_ && !as_before && !used_;
  plot_->setTuning(tuning_, stale_);
  dial_->setTuning(tuning_, stale_);
  dial_->setUsed(used_);
  plot_->setUsed(used_       ? std::optional(tuning_->front[*used_].objectives)
                 : as_before ? std::optional(tuning_->present.objectives)
                             : std::nullopt);
  changes_->setJob(present);
  showChanges();
  showState();
}

/// What would change at the point under the mouse; else what the settings in use have of those that the search began with.
void TunePage::showChanges() {
  settings_->setRowCount(0);
  const auto present = job();
  if (!tuning_ || !present) return changes_title_->setText(tr("What changes"));
  const Tuned& there = hovered_ ? tuning_->front[*hovered_] : used_ ? tuning_->front[*used_] : tuning_->present;
  const Job& before = hovered_ ? *present : *tuning_->present.job;
  changes_title_->setText(hovered_ ? tr("There: %1").arg(objectives_text(there.objectives, units_))
                                   : tr("What was changed"));
  set_heads(settings_, {tr("Setting"), hovered_ ? tr("Now") : tr("Before"), hovered_ ? tr("There") : tr("Now")});
  for (const SettingDifference& d : setting_differences(before, *there.job, units_)) {
    const int row = settings_->rowCount();
    settings_->insertRow(row);
    settings_->setItem(row, kSettingName, new QTableWidgetItem(d.title));
    for (const auto& [column, text] : {std::pair(kSettingNow, d.a), std::pair(kSettingThere, d.b)}) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      settings_->setItem(row, column, item);
    }
  }
}

void TunePage::showState() {
  const bool ending = enough_ && enough_->load();
  button_->setText(!isSearching() ? tr("Search") : ending ? tr("Cancel") : tr("Stop"));
  name_control(button_, button_->text(),
               !isSearching() ? tr("Plan with many settings and keep those that nothing beats")
               : ending       ? tr("Leave what was found")
                              : tr("End the search with what was found so far"));
  button_->setEnabled(program_ != nullptr || isSearching());
  vibration_part_->setVisible(shakes());
  if (isSearching()) return;
  set_role(verdict_, stale_ || !trouble_.isEmpty() ? "warning" : "secondary");
  if (!trouble_.isEmpty()) return verdict_->setText(trouble_);
  if (!tuning_) return verdict_->setText(tr("Cycle time against contour error: which settings nothing beats"));
  if (stale_) return verdict_->setText(tr("Of another program or other settings: search again"));
  const QString found = tr("%1 plans, %2 that nothing beats").arg(tuning_->plans).arg(tuning_->front.size());
  if (tuning_->best)
    return verdict_->setText(found + " · " +
                             tr("best %1").arg(objectives_text(tuning_->front[*tuning_->best].objectives, units_)));
  verdict_->setText(found + " · " + tr("none keeps the limit"));
}

void TunePage::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
  changes_->setTheme(theme);
}

void TunePage::setUnits(Units units) {
  units_ = units;
  for (auto* limit : {limit_, vibration_}) limit->setUnit(error_unit(units));
  limit_unit_->setText(limit_->unitText());
  vibration_unit_->setText(vibration_->unitText());
  plot_->setUnits(units);
  dial_->setUnits(units);
  changes_->setUnits(units);
  showChanges();
  showState();
}

void TunePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (outdated_) look();
}

void TunePage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  body_->setDirection(width() < kBesideEachOther ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void TunePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void TunePage::retranslate() {
  vary_->retranslate();
  limit_label_->setText(tr("Contour error ≤"));
  limit_->setUnlimitedText(tr("as now"));
  name_control(
      limit_, tr("Largest contour error"),
      tr("Largest contour error through the drives that the best may have; empty: that of the settings as they are"));
  vibration_label_->setText(tr("Vibration ≤"));
  vibration_->setUnlimitedText(tr("as now"));
  name_control(
      vibration_, tr("Largest vibration"),
      tr("Largest residual of an axis after a stop that the best may have; empty: that of the settings as they are"));
  plans_label_->setText(tr("Plans"));
  name_control(plans_, tr("Number of plans"), tr("How many plans the search may make"));
  name_control(settings_, tr("Settings that change"));
  plot_->retranslate();
  dial_->retranslate();
  changes_->retranslate();
  of_controller_->retranslate();
  showChanges();
  showState();
}

}  // namespace toolpace::ui
