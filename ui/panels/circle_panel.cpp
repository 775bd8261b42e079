#include "panels/circle_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "theme/control_name.h"
#include "theme/icons.h"
#include "toolpace/plan/plan.h"

namespace toolpace::ui {
namespace {

constexpr std::array kFactors = {1, 10, 100, 1000, 10000};
constexpr int kIcon = 16;

}  // namespace

CirclePanel::CirclePanel(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      figures_(new QLabel(this)),
      previous_(new QToolButton(this)),
      next_(new QToolButton(this)),
      enlargement_(new QComboBox(this)),
      plot_(new PolarPlot(this)) {
  setObjectName("circlePanel");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 4);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 8, 0);
  row->setSpacing(4);
  previous_->setObjectName("previousCircle");
  next_->setObjectName("nextCircle");
  enlargement_->setObjectName("circleEnlargement");
  enlargement_->addItem({});
  for (const int factor : kFactors) enlargement_->addItem(QStringLiteral("×%1").arg(factor), factor);
  title_->setObjectName("circleTitle");
  figures_->setObjectName("circleFigures");
  figures_->setProperty("role", "secondary");
  figures_->setContentsMargins(8, 0, 8, 0);
  figures_->setWordWrap(true);
  for (auto* button : {previous_, next_}) {
    button->setIconSize({kIcon, kIcon});
    row->addWidget(button);
  }
  row->addWidget(title_, 1);
  row->addWidget(enlargement_);
  column->addLayout(row);
  column->addWidget(plot_, 1);
  column->addWidget(figures_);
  connect(previous_, &QToolButton::clicked, this, [this] { step(-1); });
  connect(next_, &QToolButton::clicked, this, [this] { step(+1); });
  connect(plot_, &PolarPlot::timeClicked, this, &CirclePanel::cursorTimeRequested);
  connect(enlargement_, &QComboBox::activated, this, [this](int index) {
    plot_->setEnlargement(index > 0 ? std::optional<double>(enlargement_->itemData(index).toInt()) : std::nullopt);
    showFigures();
  });
  retranslate();
}

void CirclePanel::showPlans(const Planned& plan, const Planned&) {
  if (plan.timeline == plan_.timeline && plan.proof == plan_.proof) return;
  plan_ = plan;
  stale_ = true;
  look();
}

void CirclePanel::showInstant(const std::optional<Instant>& instant) {
  if (!instant) return;
  cursor_ = instant->time;
  plot_->setCursorTime(cursor_);
  look();
}

/// Measures nothing that nobody sees.
void CirclePanel::look() {
  if (!isVisible()) return;
  const bool proven = plan_ && plan_.proof && plan_.proof->scene->trace;
  if (!proven) {
    if (!stale_) return;
    roundness_ = std::make_shared<Roundness>();
    plot_->setRoundness(roundness_);
    return showFigures();
  }
  const Outcome& outcome = *plan_.timeline->outcome();
  const bool inside =
      !roundness_->is_empty() && cursor_ >= roundness_->circle.begin && cursor_ < roundness_->circle.end;
  if (!stale_ && inside) return;
  const std::size_t block = outcome.path->size() > 0 ? segment_at(outcome.node_time, cursor_) : 0;
  if (circle_at(outcome, block)) {
    measure(block);
  } else if (stale_) {
    const auto longest = longest_arc(outcome);
    longest ? measure(*longest) : plot_->setRoundness(roundness_ = std::make_shared<Roundness>());
  }
  stale_ = false;
  showFigures();
}

void CirclePanel::measure(std::size_t block) {
  const auto circle = circle_at(*plan_.timeline->outcome(), block);
  roundness_ = std::make_shared<Roundness>(measure_roundness(*plan_.proof->scene->trace, *circle));
  plot_->setRoundness(roundness_);
}

void CirclePanel::step(int direction) {
  if (!plan_) return;
  const Outcome& outcome = *plan_.timeline->outcome();
  const bool shown = !roundness_->is_empty();
  const double from = shown ? (direction > 0 ? roundness_->circle.end - 1e-9 : roundness_->circle.begin) : cursor_;
  if (const auto block = next_circle(outcome, from, direction)) {
    emit cursorTimeRequested(circle_at(outcome, *block)->begin);
  }
}

void CirclePanel::showFigures() {
  const Circle& circle = roundness_->circle;
  const bool shown = !roundness_->is_empty();
  if (!shown) {
    title_->clear();
    figures_->clear();
    return;
  }
  const double degrees = circle.sweep * 180 / std::numbers::pi;
  title_->setText(tr("line %1 · R %2 · %3°")
                      .arg(circle.line)
                      .arg(value_text(circle.start_radius, Quantity::length, unit_, 4), number_text(degrees, 4)));
  const bool inch = unit_.inch;
  const DisplayUnit unit{inch ? 1e3 * display_unit(Quantity::length, unit_).factor : 1e3, inch ? "mil" : "µm"};
  const auto signed_text = [&](double error) {
    return QString(error < 0 ? "−" : "+") + number_text(std::abs(error) * unit.factor, 3);
  };
  const auto extreme = [&](std::size_t index) {
    const auto& point = roundness_->points[index];
    const double angle = std::fmod(point.angle * 180 / std::numbers::pi + 360, 360);
    return signed_text(point.error) + " " + unit.text + " " + tr("at %1°").arg(angle, 0, 'f', 0);
  };
  const QString which = roundness_->is_steady ? QString() : "\n" + tr("with run-in and run-out");
  figures_->setText(
      tr("radius %1 %2 · circular deviation %3 %2 · ×%4")
          .arg(signed_text(roundness_->mean), unit.text, number_text(roundness_->deviation() * unit.factor, 4),
               number_text(plot_->enlargement(), 3)) +
      which + "\n" + tr("most %1   ·   least %2").arg(extreme(roundness_->highest), extreme(roundness_->lowest)));
}

void CirclePanel::setUnits(Units unit) {
  unit_ = unit;
  plot_->setUnit(unit);
  showFigures();
}

void CirclePanel::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
  previous_->setIcon(icon("previous", theme));
  next_->setIcon(icon("next", theme));
}

void CirclePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  look();
}

void CirclePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void CirclePanel::retranslate() {
  name_control(previous_, tr("Circle before"));
  name_control(next_, tr("Next circle"));
  name_control(enlargement_, tr("Enlargement of the radial error"));
  enlargement_->setItemText(0, tr("auto"));
  name_control(plot_, tr("Radial error of the simulated drives over the angle"), tr("Click on the curve to go there"));
  plot_->setEmptyHint(tr("no arc in this program, or not simulated yet"));
  figures_->setAccessibleName(tr("Circular deviation"));
  showFigures();
}

}  // namespace toolpace::ui
