#pragma once
/// Title bar of a panel: a quiet heading, a badge, room for the panel's own controls.

#include <QHBoxLayout>
#include <QLabel>
#include <QWidget>

namespace toolpace::ui {

class DockTitle : public QWidget {
  Q_OBJECT

 public:
  explicit DockTitle(QWidget* parent = nullptr);

  void setTitle(const QString& title);
  enum class Badge { warning, note };
  /// A few words beside the title, such as "stale"; empty = none.
  void setBadge(const QString& text, const QString& tip, Badge kind = Badge::warning);

  QSize sizeHint() const override;  ///< what a dock makes room for
  QSize minimumSizeHint() const override;

 private:
  QLabel *title_, *badge_;
  QHBoxLayout* row_;
};

}  // namespace toolpace::ui
