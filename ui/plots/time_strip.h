#pragma once
/// What the strips under the plots share: one time axis between the same left and right edge as the plots.

#include <QWidget>
#include <memory>

#include "drawing/profile_series.h"
#include "theme/theme.h"

namespace toolpace::ui {

/// What the whole program shows before its begin and after its end, of its duration.
inline constexpr double kTimeMargin = 0.01;

class TimeStrip : public QWidget {
 public:
  using QWidget::QWidget;

  void setTheme(const Theme& theme) { (theme_ = theme, refresh()); }
  void setSeries(std::shared_ptr<const ProfileSeries> series) { (series_ = std::move(series), refresh()); }
  /// Left and right edge of the plots [px of this widget].
  void setEdges(double left, double right) {
    if (left == left_ && right == right_) return;
    left_ = left;
    right_ = right;
    refresh();
  }

 protected:
  virtual void refresh() { update(); }

  Theme theme_ = light_theme();
  std::shared_ptr<const ProfileSeries> series_;
  double left_ = 60, right_ = 300;
};

}  // namespace toolpace::ui
