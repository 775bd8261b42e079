#include "panels/causes_panel.h"

#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "drawing/cause_style.h"
#include "panels/figure_table.h"

namespace toolpace::ui {

CausesPanel::CausesPanel(QWidget* parent) : QWidget(parent), causes_(figure_table("causeTable", 3, this)) {
  setObjectName("causesPanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(causes_);
  retranslate();
}

void CausesPanel::showPlans(const Planned& plan, const Planned&) {
  if (plan.timeline == timeline_) return;
  timeline_ = plan.timeline;
  stale_ = true;
  update();
}

// Docks behind other tabs count as visible, but they are not painted.
void CausesPanel::paintEvent(QPaintEvent* event) {
  if (stale_) QMetaObject::invokeMethod(this, &CausesPanel::showCauses, Qt::QueuedConnection);
  QWidget::paintEvent(event);
}

void CausesPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  showCauses();
}

void CausesPanel::showCauses() {
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

void CausesPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    showCauses();
  }
  QWidget::changeEvent(event);
}

void CausesPanel::retranslate() {
  set_heads(causes_, {tr("Held down by"), tr("Time") + "  s", "%"});
  causes_->setAccessibleName(tr("Where the time goes"));
}

}  // namespace toolpace::ui
