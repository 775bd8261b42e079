#pragma once
/// Speed, acceleration, jerk and distance of a single move over time, its phases shaded and labelled.

#include <qcustomplot.h>

#include <array>
#include <vector>

#include "models/move_preview.h"
#include "theme/theme.h"

namespace toolpace::ui {

class MovePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit MovePlot(QWidget* parent = nullptr);

  void setMove(const MovePreview& preview, double feed);
  void clearMove();
  void setUnits(MoveUnits units);
  void setTheme(const Theme& theme);
  void retranslate();

  /// The durations as labelled, in order; empty where a phase is too narrow for any label.
  QStringList phaseLabels() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  static constexpr std::size_t kRows = 4;
  struct Row {
    QCPAxisRect* rect = nullptr;
    QCPGraph* curve = nullptr;
  };
  struct Band {
    std::array<QCPItemRect*, kRows> shades;
    QCPItemText* label;
    MovePhase phase;
  };

  void buildRow(std::size_t index);
  void buildBands();
  void clearBands();
  void dressBands();
  void fitLabels();
  void setRanges(const MovePreview& preview, double feed);
  QColor shadeOf(MovePhase::Kind kind) const;

  QCPAxisRect* strip_;  ///< above the plots, for the durations
  std::array<Row, kRows> rows_;
  QCPGraph* feed_;
  std::vector<Band> bands_;
  std::vector<MovePhase> phases_;
  MoveUnits units_ = MoveUnits::pulses;
  Theme theme_ = light_theme();
};

}  // namespace toolpace::ui
