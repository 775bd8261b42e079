#pragma once
/// A time as a bar of its parts.

#include <QColor>
#include <QString>
#include <QWidget>
#include <vector>

namespace toolpace::ui {

/// The part under the mouse is named; who cannot see it reads all of them.
class LimitBar : public QWidget {
 public:
  struct Part {
    QString name;
    double time;  ///< [s]
    QColor colour;
  };

  explicit LimitBar(QWidget* parent = nullptr);

  void setParts(std::vector<Part> parts);
  QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  double whole() const;
  QString textOf(const Part& part) const;

  std::vector<Part> parts_;
};

}  // namespace toolpace::ui
