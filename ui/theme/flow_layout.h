#pragma once
/// A row of controls that goes on in the next row where there is no room.

#include <QLayout>
#include <vector>

namespace toolpace::ui {

/// From left to right, each as wide as it wants to be, the last one as wide as what is left of its row; rows below each other. As
/// narrow as its widest item.
class FlowLayout : public QLayout {
 public:
  explicit FlowLayout(QWidget* parent);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize minimumSize() const override;
  QSize sizeHint() const override;
  void setGeometry(const QRect& rect) override;

 private:
  using Row = std::vector<QLayoutItem*>;
  std::vector<Row> rowsFor(int width) const;
  int arrange(const QRect& rect, bool move) const;

  std::vector<QLayoutItem*> items_;
};

}  // namespace toolpace::ui
