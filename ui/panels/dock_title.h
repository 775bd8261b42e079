#pragma once
/// Title bar of a panel: a quiet heading, a "stale" badge, room for the panel's own controls.

#include <QHBoxLayout>
#include <QLabel>
#include <QWidget>

namespace toolpace::ui {

class DockTitle : public QWidget {
  Q_OBJECT

 public:
  explicit DockTitle(QWidget* parent = nullptr);

  void setTitle(const QString& title);
  void setStale(bool stale);
  void addControl(QWidget* control);

  QSize sizeHint() const override;  ///< what a dock makes room for
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QLabel *title_, *stale_;
  QHBoxLayout* row_;
};

}  // namespace toolpace::ui
