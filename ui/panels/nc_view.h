#pragma once
/// The NC program as text: line numbers, a gutter of speeds and losses, problems, the line under the tool.

#include <QAbstractScrollArea>
#include <QPointer>
#include <algorithm>
#include <memory>
#include <vector>

#include "drawing/colour_map.h"
#include "models/document.h"
#include "models/timeline.h"
#include "models/units.h"
#include "theme/theme.h"

class QLineEdit;

namespace toolpace::ui {

/// Draws only the lines in sight, so a program of a million lines scrolls like one of ten. A line is edited in place
/// (double click, F2, Enter); Escape leaves it as it was.
class NcView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  explicit NcView(QWidget* parent = nullptr);

  /// @param another  another program than before, seen from its beginning
  void setDocument(std::shared_ptr<const Document> document, bool another);
  /// The text as it was edited just now, at this line; what is read from it comes later, as a document.
  void setText(const ProgramText& text, int line);
  /// @param full_speed  [mm/s] that the upper end of the colour map stands for, as in the preview
  void setTimeline(std::shared_ptr<const Timeline> timeline, double full_speed);
  /// A column of what each line takes. @param times  [s] by line on a controller; null = as planned
  void setTimes(bool shown, std::shared_ptr<const std::vector<double>> times);
  double timeOf(int line) const;  ///< [s] as the column has it; 0 where it takes none
  void setProblems(const Diagnostics& problems);
  void setTheme(const Theme& theme);
  static QColor lossColour(const Theme& theme);  ///< of the bars of time lost
  void setColourMap(ColourMap map);
  const ColourTable& colours() const { return colours_; }
  void setUnit(Units unit) { unit_ = unit; }
  void setEmptyHint(const QString& text);

  const std::shared_ptr<const Document>& document() const { return document_; }
  int currentLine() const { return current_; }
  void setCurrentLine(int line);  ///< scrolls it into sight; emits nothing
  void editCurrentLine();
  void commitEdit();   ///< what is being typed becomes the line
  void insertLine();   ///< below the current one, to be written at once
  void removeLines();  ///< those selected
  /// Selects the next line that contains `text`, from the current one on; wraps around. False where there is none.
  bool findNext(const QString& text, bool backwards = false);
  void copySelection() const;
  int lineAt(int y) const;  ///< [px of the viewport]
  bool isSelected(int line) const { return line >= std::min(current_, anchor_) && line <= std::max(current_, anchor_); }

 signals:
  void lineActivated(int line);       ///< a person chose this line
  void currentLineChanged(int line);  ///< by a person or by the cursor; also when another program is shown
  void lineEdited(int line, const QString& text);
  void lineInserted(int after);
  void linesRemoved(int first, int count);
  void findRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;
  bool viewportEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Gutter {
    int number_end, loss_begin, loss_end, speed_begin, time_end, text_begin;
  };

  int lineCount() const;
  int lineHeight() const;
  int visibleLines() const;
  Gutter gutter() const;
  QRect lineRect(int line) const;
  void updateScrollBars();
  void activate(int line, bool extend);
  void paintLine(QPainter& painter, int line, const Gutter& g) const;
  void paintGutter(QPainter& painter, int line, const QRect& row, const Gutter& g) const;
  void paintText(QPainter& painter, int line, const QRect& row, const Gutter& g) const;
  const Diagnostic* problemOf(int line) const;
  QString tipOf(int line) const;
  void placeEditor();
  void finishEdit(bool take);

  std::shared_ptr<const Document> document_;
  ProgramText text_;  // newer than the document while that is being read
  std::shared_ptr<const Timeline> timeline_;
  std::shared_ptr<const std::vector<double>> times_;
  bool has_times_ = false;
  Diagnostics problems_;  // sorted by line
  Theme theme_ = light_theme();
  ColourMap map_ = ColourMap::cividis;
  ColourTable colours_;
  QString empty_hint_;
  Units unit_;
  double fastest_ = 0, worst_loss_ = 0;
  int current_ = 1, anchor_ = 1;
  QPointer<QLineEdit> editor_;
  int editor_line_ = 1;
};

}  // namespace toolpace::ui
