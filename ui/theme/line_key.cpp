#include "theme/line_key.h"

#include <QPainter>
#include <cmath>

namespace toolpace::ui {
namespace {

constexpr double kSampleWidth = 18, kBarHeight = 8, kGap = 4, kApart = 12;  // px

}  // namespace

LineKey::LineKey(const QString& object_name, QWidget* parent) : QWidget(parent) {
  setObjectName(object_name);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void LineKey::setSamples(std::vector<KeySample> samples) {
  samples_ = std::move(samples);
  QStringList names;
  for (const KeySample& sample : samples_) names << sample.text;
  setAccessibleDescription(names.join(", "));
  updateGeometry();
  update();
}

void LineKey::setTextColour(const QColor& colour) {
  text_ = colour;
  update();
}

QSize LineKey::sizeHint() const {
  double wide = 0;
  for (const KeySample& sample : samples_) {
    wide += kSampleWidth + kGap + fontMetrics().horizontalAdvance(sample.text) + kApart;
  }
  return {static_cast<int>(std::ceil(std::max(wide - kApart, 0.0))) + 1, fontMetrics().height()};
}

void LineKey::paintInto(QPainter& painter, const QRectF& area) const {
  const double middle = std::floor(area.center().y()) + 0.5;
  double x = area.left();
  for (const KeySample& sample : samples_) {
    const QRectF bar(x, middle - kBarHeight / 2, kSampleWidth, kBarHeight);
    if (sample.bar.style() != Qt::NoBrush) {
      painter.fillRect(bar, sample.bar);
    } else {
      painter.setPen(sample.line);
      painter.drawLine(QPointF(x, middle), QPointF(x + kSampleWidth, middle));
    }
    const double wide = fontMetrics().horizontalAdvance(sample.text);
    painter.setPen(text_);
    painter.drawText(QRectF(x + kSampleWidth + kGap, area.top(), wide + 2, area.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, sample.text);
    x += kSampleWidth + kGap + wide + kApart;
  }
}

void LineKey::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintInto(painter, rect());
}

}  // namespace toolpace::ui
