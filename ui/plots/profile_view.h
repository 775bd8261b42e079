#pragma once
/// The motion plots with their controls, the binding-limit ribbon and the overview: shows immutable series, emits
/// intent.

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "drawing/contour_scene.h"
#include "drawing/plan_view.h"
#include "drawing/profile_series.h"
#include "models/units.h"
#include "theme/picture_file.h"
#include "theme/theme.h"
#include "toolpace/base/result.h"

class QLabel;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace toolpace::ui {

class LimitRibbon;
class LineKey;
class OverviewStrip;
class ProfilePlot;
class ValueTable;

class ProfileView : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit ProfileView(QWidget* parent = nullptr);

  /// Shows a series made by make_profile_series(); null = nothing. The visible time stays unless all was visible.
  void setSeries(std::shared_ptr<const ProfileSeries> series);
  /// Plan B, dashed; null = none.
  void setGhost(std::shared_ptr<const ProfileSeries> series);

  /// Contour error of a simulation; null = not simulated. A fourth plot shows it once somebody asks for it.
  void setErrorTrace(std::shared_ptr<const ErrorTrace> trace);
  void setErrorShown(bool shown);
  /// How far axes with modes swing: null where none has one.
  void setVibration(const std::shared_ptr<const VibrationTrace>& trace);
  void setVibrationShown(bool shown);
  void setFollowShown(bool shown);  ///< of a trace: the following error of each axis

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void showTrace(const std::shared_ptr<const MeasuredTrace>& trace) override;
  void showInstant(const std::optional<Instant>& instant) override;
  void setTheme(const Theme& theme) override;
  void setUnits(Units unit) override;
  void setCursorTime(std::optional<double> time);        ///< [s]
  void setVisibleRange(double begin, double end);        ///< [s]
  void setRotaryAxes(const std::array<bool, 3>& there);  ///< which of A, B, C can be shown
  void setMeasuring(bool on);
  void setAxisShown(std::size_t axis, bool shown);  ///< 0 = X …
  void showReadyAxes();                             ///< axes that were being made are there
  void setTableShown(bool shown);                   ///< the visible values as a table instead of curves
  void fit();

  std::pair<double, double> visibleRange() const;
  /// Time under a point of the view; nothing beside the curves.
  std::optional<double> timeAt(const QPoint& at) const;
  bool isMeasuring() const;
  /// Differences between the measuring cursors as shown, such as "Δt 0.500 s  Δv …"; empty when not measuring.
  QString measureText() const;
  ProfilePlot& plot() { return *plot_; }

  /// Saves plots and ribbon as they are: .png, .svg or .pdf by extension. Errors: those of save_picture.
  Result<void> exportPicture(const QString& file) const;
  /// The same to be drawn elsewhere, while this view lives.
  Drawing drawing() const;

 signals:
  void cursorTimeRequested(double time);               ///< [s] somebody clicked
  void visibleRangeChanged(double begin, double end);  ///< [s]
  void measuringChanged(bool on);
  void axesShown(const toolpace::ui::ShownAxes& shown);

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void buildHeader();
  void buildTable();
  void retranslate();
  void fillKey();
  void updateReadout();
  /// With a fixed number of decimals, so that digits do not jump while the cursor moves.
  QString steadyText(double core_value, Quantity quantity, int decimals) const;
  void alignStrips();
  void paintAll(QPainter& painter) const;
  void paintRibbon(QPainter& painter) const;
  QImage picture(const QSize& size) const;

  QWidget* header_;
  QLabel* readout_;
  QToolButton* measure_;
  QToolButton* fit_;
  LineKey* key_;
  QToolButton* show_error_;
  QToolButton *show_follow_, *show_vibration_;
  QToolButton* show_table_;
  std::array<QToolButton*, kAxisCount> axes_ = {};
  QStackedWidget* pages_;
  ProfilePlot* plot_;
  QTableView* table_;
  ValueTable* values_;
  LimitRibbon* ribbon_;
  OverviewStrip* overview_;
  std::array<bool, 3> rotary_ = {};
  std::shared_ptr<const ProfileSeries> series_;
  std::optional<double> cursor_;
  Theme theme_ = light_theme();
  bool has_ghost_ = false, has_trace_ = false;
  Units unit_;
};

}  // namespace toolpace::ui
