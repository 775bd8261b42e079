#include "panels/limit_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStringList>
#include <QToolTip>
#include <numeric>

#include "models/units.h"

namespace toolpace::ui {
namespace {

constexpr int kBarHeight = 12;

}  // namespace

LimitBar::LimitBar(QWidget* parent) : QWidget(parent) {
  setObjectName("limitBar");
  setFixedHeight(kBarHeight);
}

void LimitBar::setParts(std::vector<Part> parts) {
  parts_ = std::move(parts);
  QStringList all;
  for (const Part& part : parts_) all << textOf(part);
  setAccessibleDescription(all.join(", "));
  update();
}

double LimitBar::whole() const {
  return std::accumulate(parts_.begin(), parts_.end(), 0.0, [](double sum, const Part& p) { return sum + p.time; });
}

QString LimitBar::textOf(const Part& part) const {
  const double all = whole();
  return QString("%1: %2, %3 %")
      .arg(part.name, duration_text(part.time), QString::number(all > 0 ? part.time / all * 100 : 0, 'f', 1));
}

QSize LimitBar::sizeHint() const { return {200, kBarHeight}; }

bool LimitBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  double at = whole() * help->x() / std::max(width(), 1);
  for (const Part& part : parts_) {
    if ((at -= part.time) > 0) continue;
    QToolTip::showText(help->globalPos(), textOf(part), this);
    return true;
  }
  QToolTip::hideText();
  return true;
}

void LimitBar::paintEvent(QPaintEvent*) {
  const double all = whole();
  if (!(all > 0)) return;
  QPainter painter(this);
  double passed = 0;
  for (const Part& part : parts_) {
    const int from = static_cast<int>(passed / all * width());
    passed += part.time;
    painter.fillRect(QRect(QPoint(from, 0), QPoint(static_cast<int>(passed / all * width()) - 1, height() - 1)),
                     part.colour);
  }
}

}  // namespace toolpace::ui
