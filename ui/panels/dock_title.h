#pragma once
/// Title bar of a panel: a quiet heading, a badge; while the panel is a window of its own, buttons to dock and to close it.

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "theme/theme.h"

class QDockWidget;

namespace toolpace::ui {

class DockTitle : public QWidget {
  Q_OBJECT

 public:
  /// @param when_docked  whether it is seen while the panel is docked; else its tab or its own controls say what it is
  explicit DockTitle(QDockWidget* dock, bool when_docked);

  void setTheme(const Theme& theme);

  enum class Badge { warning, note };
  /// A few words beside the title, such as "stale"; empty = none.
  void setBadge(const QString& text, const QString& tip, Badge kind = Badge::warning);

  QSize sizeHint() const override;  ///< what a dock makes room for
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* addButton(const QString& name, const char* icon_name);
  void showButtons(bool floating);
  void retranslate();
  int wantedHeight() const;

  bool when_docked_, floating_ = false;
  QLabel *title_, *badge_;
  QHBoxLayout* row_;
  QToolButton *dock_, *close_;
};

}  // namespace toolpace::ui
