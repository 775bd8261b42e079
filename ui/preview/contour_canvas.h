#pragma once
/// The drawing area of the contour preview: camera, picture, what lies over it, mouse and keys.

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "drawing/colour_map.h"
#include "drawing/contour_scene.h"
#include "models/instant.h"
#include "models/units.h"
#include "preview/scene_draw.h"
#include "preview/scene_pick.h"
#include "preview/tube_draw.h"
#include "theme/theme.h"

namespace toolpace::ui {

class ContourCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit ContourCanvas(QWidget* parent = nullptr);

  void setScene(std::shared_ptr<const ContourScene> scene);
  void setGhost(std::shared_ptr<const ContourScene> scene);
  void setTheme(const Theme& theme);
  void setUnit(Units unit);
  void setColourBy(ColourBy by);
  void setColourMap(ColourMap map);
  void setEnlargement(double factor);   ///< of the contour error, ≥ 1
  void setTolerance(double tolerance);  ///< [mm] half width of the band while there is no tube; 0 = none
  /// The plan inside the tolerance band; null = it stays on the programmed path.
  void setTube(std::shared_ptr<const TubeTrace> tube);
  void setBandShown(bool shown);
  /// Where a scope says that the machine went; null = nothing. Its distance from the path is enlarged, too.
  void setMeasured(std::shared_ptr<const ErrorTrace> measured);
  bool showsMeasured() const { return measured_ != nullptr && scene_ != nullptr; }
  /// Rapids that are not drawn are not fitted to and not clicked at, either.
  void setRapidsShown(bool shown);
  bool areRapidsShown() const { return rapids_shown_; }
  void setCursorTime(std::optional<double> time);
  std::optional<double> cursorTime() const { return cursor_time_; }
  void setHighlight(std::optional<std::pair<double, double>> span);  ///< [s]

  void setView(View view);
  void fit();
  void zoomBy(double factor, const QPointF& fixed);
  const Projection& projection() const { return projection_; }
  void setProjection(const Projection& projection);
  std::optional<double> timeAt(const QPoint& at) const;  ///< [s] when the tool is there; nothing beside the path

  const std::shared_ptr<const ContourScene>& scene() const { return scene_; }
  bool hasGhost() const { return ghost_ != nullptr; }
  /// The simulated drives are drawn beside the path.
  bool showsTrace() const { return scene_ && scene_->trace && enlargement_ > 1.0 && !(tube_ && band_shown_); }
  const Theme& theme() const { return theme_; }
  Units unit() const { return unit_; }
  ColourBy colourBy() const { return by_; }
  const ColourTable& colours() const { return colours_; }
  const std::optional<Instant>& hovered() const { return hovered_; }

  /// The picture without what follows the cursor, `size` logical px at `scale`, drawn smooth.
  QImage render(const QSize& size, double scale) const;
  /// The same as vectors, for SVG and PDF: at most as many lines as a picture of this size can tell apart.
  void paintVectors(QPainter& painter, const QSizeF& size) const;

  /// What stands over the picture at its lower edge, where it is as large as the canvas.
  void drawAxes(QPainter& painter) const;
  void drawScaleBar(QPainter& painter) const;

  /// The camera moves or plans follow each other: a better picture comes when they rest.
  bool isMoving() const { return moving_; }
  /// Pieces of the last picture, and how often the path was drawn anew. For the tests of what a picture costs.
  std::size_t lastPieces() const { return last_pieces_; }
  std::size_t picturesDrawn() const { return pictures_drawn_; }

 signals:
  void cursorTimeRequested(double time);
  void hoverChanged();
  void menuRequested(const QPoint& at);  ///< a right button that turned nothing
  /// It is looked at from another side: of a view, or of none where it was orbited.
  void turned(std::optional<View> view);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  QSize sizeHint() const override { return {640, 420}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 private:
  void moved();   // the camera moved: draw quickly now, smoothly when it rests
  void redraw();  // the contents changed
  bool canBeSmooth(const QSize& pixels, const Projection& projection) const;
  void drawPicture(QImage& image, const Projection& projection, double ratio, bool smooth) const;
  void drawTravel(QPainter& painter, const Projection& projection) const;
  void drawBand(QPainter& painter, const Projection& projection) const;
  void drawDirection(QPainter& painter, const Projection& projection, const QSizeF& size, double ratio) const;
  void drawHighlight(QPainter& painter) const;
  void drawCursor(QPainter& painter) const;
  void drawHover(QPainter& painter) const;
  void drawCaption(QPainter& painter) const;
  void drawHint(QPainter& painter) const;
  void updateColours();
  void hover(const QPointF& at);
  Projection scaled(double ratio) const;
  Box drawnBox() const;
  bool isTiny(const QPointF& delta) const;

  std::shared_ptr<const ContourScene> scene_, ghost_;
  Theme theme_ = light_theme();
  Units unit_;
  ColourBy by_ = ColourBy::speed;
  ColourMap map_ = ColourMap::cividis;
  ColourTable colours_ = {};
  double enlargement_ = 1.0, tolerance_ = 0.0;
  bool band_shown_ = true, rapids_shown_ = true;
  std::shared_ptr<const TubeTrace> tube_;
  std::shared_ptr<const ErrorTrace> measured_;

  Projection projection_;
  bool follows_fit_ = true;  // until the camera is moved by hand, a new size fits again
  QImage picture_;
  bool stale_ = true, moving_ = false;
  mutable std::size_t last_pieces_ = 0;
  std::size_t pictures_drawn_ = 0;
  QTimer settle_;
  QElapsedTimer since_scene_;

  std::optional<double> cursor_time_;
  std::optional<Instant> cursor_, hovered_;
  std::optional<std::pair<double, double>> highlight_;
  QPointF pressed_at_, dragged_from_, hover_at_;
  bool dragging_ = false;
};

}  // namespace toolpace::ui
