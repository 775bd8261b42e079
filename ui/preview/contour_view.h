#pragma once
/// The contour preview with its controls and legend: a view of immutable scenes that computes no plan and emits intent.

#include <QWidget>
#include <memory>
#include <optional>

#include "drawing/plan_view.h"
#include "models/units.h"
#include "preview/contour_canvas.h"
#include "theme/picture_file.h"
#include "toolpace/base/result.h"

class QButtonGroup;
class QComboBox;
class QToolButton;

namespace toolpace::ui {

class ContourLegend;
class LineKey;

class ContourView : public QWidget, public PlanView {
  Q_OBJECT

 public:
  explicit ContourView(QWidget* parent = nullptr);

  /// Shows a scene made by make_contour_scene(); null = nothing loaded, with the hint to drop a program. The camera
  /// stays where it is unless nothing was shown before.
  void setScene(std::shared_ptr<const ContourScene> scene);
  /// Plan B, drawn dashed beneath; null = none.
  void setGhost(std::shared_ptr<const ContourScene> scene);

  void showPlans(const Planned& plan, const Planned& pinned) override;
  void showTrace(const std::shared_ptr<const MeasuredTrace>& trace) override;
  void showInstant(const std::optional<Instant>& instant) override;
  void setTheme(const Theme& theme) override;
  void setUnits(Units unit) override;
  void setTolerance(double tolerance);                  ///< [mm] half width of the band round the path; 0 = no band
  void setTube(std::shared_ptr<const TubeTrace> tube);  ///< see ContourCanvas
  void setRapidsShown(bool shown);
  void setBandShown(bool shown);
  void setCursorTime(std::optional<double> time);  ///< [s]
  void setHighlightedLine(std::uint32_t line);     ///< NC line; 0 = none
  void setColourBy(ColourBy by);
  void setColourMap(ColourMap map);
  void setEnlargement(double factor);  ///< of the contour error, 1 … 1000
  void setView(View view);
  void fit();

  ColourBy colourBy() const;
  ColourMap colourMap() const;
  View view() const { return view_; }
  ContourCanvas& canvas() { return *canvas_; }

  /// Saves the picture with title, axes, scale bar and legend, without cursor and mouse: .png, .svg or .pdf by extension. Errors: those of save_picture.
  Result<void> exportPicture(const QString& file) const;
  /// The same to be drawn elsewhere, while this view lives.
  Drawing drawing() const;

 signals:
  void cursorTimeRequested(double time);  ///< [s] somebody clicked on the path
  void colourByChanged(toolpace::ui::ColourBy by);
  void colourMapChanged(toolpace::ui::ColourMap map);
  void enlargementChanged(double factor);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void buildHeader();
  void retranslate();
  QString title() const;
  int titleHeight() const;
  void paintAll(QPainter& painter, const QImage& picture) const;
  void showView(std::optional<View> view);
  void updateChoices();
  void fillKey();

  ContourCanvas* canvas_;
  ContourLegend* legend_;
  QWidget* header_;
  LineKey* key_;  // of what is no colour: dashes
  QComboBox* colour_by_;
  QComboBox* colour_map_;
  QComboBox* enlargement_;
  QButtonGroup* views_;
  QToolButton* band_;
  QToolButton* fit_;
  View view_ = View::xy;
  bool has_tube_ = false;
  double tolerance_ = 0;
  std::uint32_t highlighted_ = 0;
};

}  // namespace toolpace::ui
