#pragma once
/// Step rate and interval over the number of the pulse.

#include <qcustomplot.h>

#include "models/pulse_preview.h"
#include "theme/theme.h"

namespace toolpace::ui {

class PulsePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit PulsePlot(QWidget* parent = nullptr);

  void setPreview(const PulsePreview& preview);  ///< an empty one clears it
  void setTheme(const Theme& theme);
  void retranslate();

 private:
  struct Row {
    QCPAxisRect* rect;
    QCPGraph* curve;
  };
  Row rate_, interval_;
};

}  // namespace toolpace::ui
