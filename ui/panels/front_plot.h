#pragma once
/// Cycle time against contour error of the settings that nothing beats.

#include <qcustomplot.h>

#include <memory>
#include <optional>
#include <vector>

#include "models/units.h"
#include "theme/theme.h"
#include "toolpace/tune/tune.h"

namespace toolpace::ui {

/// Points are coloured by the vibration that stops leave, where it is known.
class FrontPlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit FrontPlot(QWidget* parent = nullptr);

  /// Null = none. @param stale  of another program or other settings: shown in grey
  void setTuning(std::shared_ptr<const toolpace::TuneResult> tuning, bool stale);
  /// Where the settings in use stand; nothing = they are none of these.
  void setUsed(const std::optional<Objectives>& used);
  void setUnits(Units units);
  void setTheme(const Theme& theme);
  void retranslate();

  /// Where a point of the front is drawn.
  QPointF placeOf(std::size_t index) const;

 signals:
  void hovered(std::optional<std::size_t> index);  ///< the point under the mouse, of the front
  void chosen(std::size_t index);                  ///< it was clicked at

 protected:
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  std::optional<std::size_t> near(const QPointF& at) const;
  void setHovered(std::optional<std::size_t> index);
  QPointF coordinates(const Objectives& o) const;
  void draw();
  void drawPoints();
  void drawMarks();
  void fitAxes();
  void showScale();

  QCPGraph *steps_, *hover_, *used_;
  std::vector<QCPGraph*> points_;  // one a colour
  QCPItemStraightLine* limit_;
  QCPItemText *limit_text_, *used_text_;
  QCPColorScale* scale_ = nullptr;  // while vibration is known
  std::shared_ptr<const toolpace::TuneResult> tuning_;
  std::optional<Objectives> used_at_;
  std::optional<std::size_t> hovered_;
  bool stale_ = false;
  Units units_;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
