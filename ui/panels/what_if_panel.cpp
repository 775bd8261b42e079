#include "panels/what_if_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "drawing/cause_style.h"
#include "models/parameter_names.h"
#include "models/problem_model.h"
#include "models/units.h"
#include "panels/figure_table.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr double kShown = 5e-4;  // [s]; less is nothing to a person

}  // namespace

WhatIfPanel::WhatIfPanel(QWidget* parent)
    : QWidget(parent),
      causes_(figure_table("causeTable", 3, this)),
      levers_table_(figure_table("leverTable", 3, this)),
      hint_(new QLabel(this)),
      button_(new QPushButton(this)) {
  setObjectName("whatIfPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(causes_, 1);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(hint_, 1);
  row->addWidget(button_);
  hint_->setProperty("role", "secondary");
  button_->setObjectName("whatIfButton");
  button_->setEnabled(false);
  column->addLayout(row);
  column->addWidget(levers_table_, 1);
  levers_table_->hide();
  connect(button_, &QPushButton::clicked, this, &WhatIfPanel::compute);
  connect(&service_, &TuneService::savingsFound, this, &WhatIfPanel::showSavings);
  connect(&service_, &TuneService::progressed, this,
          [this](double fraction) { hint_->setText(tr("planning… %1 %").arg(static_cast<int>(fraction * 100))); });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { hint_->setText(message_text(error.code, error.message)); });
  connect(&service_, &TuneService::finished, this, [this] {
    button_->setEnabled(timeline_ != nullptr);
    emit computed();
  });
  retranslate();
}

void WhatIfPanel::showPlans(const Planned& plan, const Planned&) {
  if (plan.timeline == timeline_) return;
  timeline_ = plan.timeline;
  service_.cancel();
  levers_table_->setRowCount(0);
  levers_table_->hide();
  button_->setEnabled(timeline_ != nullptr);
  stale_ = true;
  update();
}

// Docks behind other tabs count as visible, but they are not painted.
void WhatIfPanel::paintEvent(QPaintEvent* event) {
  if (stale_) QMetaObject::invokeMethod(this, &WhatIfPanel::showCauses, Qt::QueuedConnection);
  QWidget::paintEvent(event);
}

void WhatIfPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  showCauses();
}

void WhatIfPanel::showCauses() {
  stale_ = false;
  causes_->setRowCount(0);
  if (!timeline_) return;
  const auto& times = timeline_->outcome()->summary.time_by_cause;
  const double whole = timeline_->duration();
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return times[a] > times[b]; });
  for (std::size_t i : order) {
    if (times[i] <= 0) continue;
    const int row = causes_->rowCount();
    causes_->insertRow(row);
    const auto cause = static_cast<Cause>(i);
    const QColor colour = cause_colour(cause, theme_.dark ? Ground::dark : Ground::light);
    causes_->setItem(row, 0, new QTableWidgetItem(QIcon(colour_chip(colour)), cause_title(cause)));
    causes_->setItem(row, 1, new NumberItem(QString::number(times[i], 'f', 3), times[i]));
    causes_->setItem(row, 2, new NumberItem(QString::number(whole > 0 ? times[i] / whole * 100 : 0, 'f', 1), times[i]));
  }
}

void WhatIfPanel::compute() {
  if (!timeline_) return;
  button_->setEnabled(false);
  service_.findSavings(timeline_->outcome()->job, timeline_->duration());
}

void WhatIfPanel::showSavings(const std::vector<Saving>& savings) {
  hint_->setText(tr("10 % more of each limit"));
  const double whole = timeline_ ? timeline_->duration() : 0;
  levers_table_->setRowCount(static_cast<int>(savings.size()));
  for (int row = 0; row < levers_table_->rowCount(); ++row) {
    const Saving& saving = savings[static_cast<std::size_t>(row)];
    const bool nothing = std::abs(saving.saved) < kShown;
    const QColor colour = nothing ? theme_.secondary : saving.saved > 0 ? theme_.good : theme_.error;
    auto* title = new QTableWidgetItem(parameter_name(saving.parameter));
    title->setToolTip(
        QString("%1: %2 → %3")
            .arg(QString::fromStdString(saving.parameter), number_text(saving.value), number_text(saving.raised)));
    auto* seconds = new NumberItem(nothing ? QString("0") : QString::number(saving.saved, 'f', 3), saving.saved);
    auto* share = new NumberItem(
        nothing || whole <= 0 ? QString("0") : QString::number(saving.saved / whole * 100, 'f', 1), saving.saved);
    for (auto* item : {seconds, share}) item->setForeground(colour);
    levers_table_->setItem(row, 0, title);
    levers_table_->setItem(row, 1, seconds);
    levers_table_->setItem(row, 2, share);
  }
  levers_table_->show();
}

void WhatIfPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    showCauses();
  }
  QWidget::changeEvent(event);
}

void WhatIfPanel::retranslate() {
  set_heads(causes_, {tr("Held down by"), tr("Time") + "  s", "%"});
  set_heads(levers_table_, {tr("If raised"), tr("Saves") + "  s", "%"});
  causes_->setAccessibleName(tr("Where the time goes"));
  levers_table_->setAccessibleName(tr("What raising a limit saves"));
  hint_->setText(tr("10 % more of each limit"));
  button_->setText(tr("Plan it"));
  name_control(button_, tr("Plan again with each limit 10 % higher and list what it saves"));
}

}  // namespace toolpace::ui
