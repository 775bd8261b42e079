#include "panels/controller_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawing/cause_style.h"
#include "models/controller_names.h"
#include "models/problem_model.h"
#include "models/units.h"
#include "panels/figure_table.h"
#include "panels/form_grid.h"
#include "theme/control_name.h"
#include "toolpace/pipeline/run_on_controller.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastSaved = 5e-4;  // [s]; less is nothing to a person

constexpr int kSettingColumns = 3;  // setting, value, seconds

/// Without the section where the key alone says enough; an axis has the same keys as another.
QString brief_name(const WhatIf& what) {
  const auto end = what.setting.find("] ");
  const bool is_of_axis = what.setting.starts_with("[AXIS_");
  if (end == std::string::npos || is_of_axis) return setting_name(what.setting, what.title);
  return QString::fromStdString(what.setting.substr(end + 2));
}

}  // namespace

ControllerPanel::ControllerPanel(QWidget* parent)
    : QWidget(parent),
      verdict_(new QLabel(this)),
      hint_(new QLabel(this)),
      supply_(new SupplyFields("controller", this)),
      grid_(new FormGrid(this)),
      bar_(new LimitBar(this)),
      limits_(figure_table("timeLimitTable", 3, this)),
      rows_table_(figure_table("settingTable", kSettingColumns, this)),
      button_(new QPushButton(this)) {
  setObjectName("controllerPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(4);
  verdict_->setObjectName("controllerVerdict");
  verdict_->setWordWrap(true);
  verdict_->setContentsMargins(8, 0, 8, 0);
  column->addWidget(verdict_);
  grid_->setContentsMargins(8, 0, 8, 0);
  baud_label_ = grid_->add(0, 0, supply_->baud());
  block_time_label_ = grid_->add(0, 1, supply_->blockTime());
  column->addWidget(grid_);
  connect(supply_, &SupplyFields::edited, this, [this] { emit supplyWanted(supply_->value()); });
  auto* bar_row = new QHBoxLayout;
  bar_row->setContentsMargins(8, 0, 8, 0);
  bar_row->addWidget(bar_);
  column->addLayout(bar_row);
  column->addWidget(limits_, 2);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 8, 0);
  row->addWidget(hint_, 1);
  row->addWidget(button_);
  hint_->setObjectName("settingHint");
  hint_->setProperty("role", "secondary");
  hint_->setWordWrap(true);
  button_->setObjectName("trySettingsButton");
  column->addLayout(row);
  column->addWidget(rows_table_, 3);
  rows_table_->hide();
  connect(button_, &QPushButton::clicked, this, [this] { isComputing() ? stop() : compute(); });
  connect(rows_table_, &QTableWidget::cellActivated, this, [this](int index) { takeRow(index); });
  connect(&service_, &TuneService::settingsTried, this, [this](const std::vector<WhatIf>& rows) {
    rows_ = rows;
    has_rows_ = true;
    showRows();
  });
  connect(&service_, &TuneService::progressed, this, [this](double fraction) {
    if (isComputing()) hint_->setText(tr("trying… %1 %").arg(static_cast<int>(fraction * 100)));
  });
  connect(&service_, &TuneService::finished, this, [this] {
    showHint();
    emit computed();
  });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { hint_->setText(message_text(error.code, error.message)); });
  retranslate();
}

void ControllerPanel::showController(const ControllerView& view) {
  const bool same = view.found == view_.found && view.chosen == view_.chosen;
  view_ = view;
  supply_->setValue(view.supply);
  showSupply();
  if (!same) {
    service_.cancel();
    rows_.clear();
    has_rows_ = false;
    showLimits();
    showRows();
    showHint();
  }
  showVerdict();
}

void ControllerPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  showLimits();
  showRows();
}

void ControllerPanel::compute() {
  if (!view_.found || view_.is_stale) return;
  service_.trySettings(view_.found);
  showHint();
}

void ControllerPanel::stop() {
  service_.cancel();
  showHint();
}

void ControllerPanel::showSupply() {
  supply_->retranslate();
  const bool is_linked = !view_.chosen || !reads_own_disk(view_.chosen->settings.controller);
  grid_->setRowUseless(supply_->baud(), is_linked ? QString() : tr("It reads programs from its own disk"));
}

void ControllerPanel::showVerdict() {
  if (view_.failure) return verdict_->setText(message_text(view_.failure->code, view_.failure->message));
  if (!view_.found) return verdict_->setText(view_.chosen ? tr("predicting…") : tr("Choose a controller: Runs on"));
  const Prediction& p = view_.found->prediction;
  verdict_->setText(controller_verdict(p, view_.as_setpoints) + (view_.is_stale ? "  " + tr("(stale)") : QString()));
}

void ControllerPanel::showLimits() {
  limits_->setRowCount(0);
  std::vector<LimitBar::Part> parts;
  if (view_.found) {
    const Prediction& p = view_.found->prediction;
    const double whole = std::accumulate(p.time_by_limit.begin(), p.time_by_limit.end(), 0.0);
    for (std::size_t i = 0; i < kTimeLimitCount; ++i) {
      if (!(p.time_by_limit[i] > 0)) continue;
      const auto limit = static_cast<TimeLimit>(i);
      const QColor colour = cause_colour(cause_of(limit), theme_.dark ? Ground::dark : Ground::light);
      parts.push_back({time_limit_title(limit), p.time_by_limit[i], colour});
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.time > b.time; });
    limits_->setRowCount(static_cast<int>(parts.size()));
    for (int row = 0; row < limits_->rowCount(); ++row) {
      const LimitBar::Part& part = parts[static_cast<std::size_t>(row)];
      limits_->setItem(row, 0, new QTableWidgetItem(QIcon(colour_chip(part.colour)), part.name));
      limits_->setItem(row, 1, new NumberItem(QString::number(part.time, 'f', 3), part.time));
      limits_->setItem(row, 2, new NumberItem(QString::number(part.time / whole * 100, 'f', 1), part.time));
    }
  }
  bar_->setParts(std::move(parts));
}

void ControllerPanel::showRows() {
  rows_table_->setVisible(has_rows_);
  rows_table_->setRowCount(static_cast<int>(rows_.size()));
  const double now = view_.found ? view_.found->prediction.cycle_time : 0;
  for (int row = 0; row < rows_table_->rowCount(); ++row) {
    const WhatIf& what = rows_[static_cast<std::size_t>(row)];
    const double saved = now - what.cycle_time;
    const bool nothing = std::abs(saved) < kLeastSaved;
    const QColor colour = nothing ? theme_.secondary : saved > 0 ? theme_.good : theme_.error;
    const QString unit = setting_unit(what.unit);
    auto* name = new QTableWidgetItem(brief_name(what));
    name->setToolTip(setting_name(what.setting, what.title) + ": " + number_text(what.from) + " → " +
                     number_text(what.to) + ' ' + unit + "\n" + setting_title(what.title) + "\n" +
                     tr("Double click: take this value"));
    auto* values = new QTableWidgetItem("→ " + number_text(what.to) + (unit.isEmpty() ? QString() : ' ' + unit));
    values->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* seconds = new NumberItem(nothing ? QString("0") : QString::number(saved, 'f', 3), saved);
    seconds->setForeground(colour);
    int column = 0;
    for (auto* item : {name, values, static_cast<QTableWidgetItem*>(seconds)}) {
      rows_table_->setItem(row, column++, item);
    }
  }
}

void ControllerPanel::showHint() {
  const bool runs = isComputing();
  button_->setText(runs ? tr("Cancel") : tr("Try the settings"));
  name_control(button_, button_->text(), tr("Predict with each setting 10 % up and down and at its next round value"));
  button_->setEnabled(runs || (view_.found && !view_.is_stale));
  hint_->setText(runs ? tr("trying…") : tr("What each setting would save"));
}

void ControllerPanel::takeRow(int row) {
  if (row < 0 || row >= static_cast<int>(rows_.size())) return;
  const WhatIf& what = rows_[static_cast<std::size_t>(row)];
  emit settingWanted(QString::fromStdString(what.setting), what.to);
}

void ControllerPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ControllerPanel::retranslate() {
  set_heads(limits_, {tr("Held down by"), tr("Time") + "  s", "%"});
  set_heads(rows_table_, {tr("Setting"), tr("Value"), tr("Saves") + "  s"});
  showSupply();
  baud_label_->setText(SupplyFields::baudTitle());
  block_time_label_->setText(SupplyFields::blockTimeTitle());
  limits_->setAccessibleName(tr("Where the time goes on the controller"));
  rows_table_->setAccessibleName(tr("What each setting would save"));
  name_control(bar_, tr("Where the time goes on the controller"));
  showVerdict();
  showLimits();
  showRows();
  showHint();
}

}  // namespace toolpace::ui
