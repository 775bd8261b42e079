#pragma once
/// What lines and bars in a picture stand for: a sample of each, and its name.

#include <QBrush>
#include <QPen>
#include <QWidget>
#include <vector>

namespace toolpace::ui {

/// A line where there is no brush, else a bar.
struct KeySample {
  QString text;
  QPen line;
  QBrush bar = {};
};

/// In one row. Stands beside the picture, never over it; in exported pictures, too.
class LineKey : public QWidget {
  Q_OBJECT

 public:
  explicit LineKey(const QString& object_name, QWidget* parent = nullptr);

  void setSamples(std::vector<KeySample> samples);
  void setTextColour(const QColor& colour);
  const std::vector<KeySample>& samples() const { return samples_; }

  /// Draws it into a row of this height.
  void paintInto(QPainter& painter, const QRectF& area) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<KeySample> samples_;
  QColor text_ = Qt::black;
};

}  // namespace toolpace::ui
