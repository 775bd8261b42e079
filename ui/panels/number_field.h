#pragma once
/// A number with its unit, entered exactly.

#include <QLineEdit>
#include <QTimer>

#include "models/units.h"

namespace toolpace::ui {

/// Shows and edits one value in core units. Text that is no number, or out of range, is marked and not taken over;
/// Escape brings the old value back. Up, Down and the wheel (with focus) step by about a twentieth; Ctrl: by a half.
///
/// It is as wide as its longest value in whatever unit, and where a layout gives it less it never shows a part of a number
/// without saying so.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  struct Range {
    double least, most;             ///< core units, inclusive
    bool may_be_unlimited = false;  ///< an empty field or "∞" means no limit
    bool whole = false;             ///< integers only
  };

  NumberField(const QString& object_name, const QString& accessible_name, Quantity quantity, Range range,
              QWidget* parent = nullptr);

  void setValue(double core_value);
  double value() const { return value_; }
  /// A display unit of its own, such as ms for seconds.
  void setUnit(const DisplayUnit& unit);
  void setUnits(Units unit);
  QString unitText() const { return unit_.text; }
  /// What stands for no limit; "∞" at first.
  void setUnlimitedText(const QString& text);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void edited(double core_value);
  void gestureStarted();  ///< several edits that belong together follow
  void gestureFinished();
  void unitChanged();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void show_value();
  void commit();
  void step(double direction, bool large);
  void mark(const QString& trouble);
  QString range_text() const;
  QString whole_text() const;
  int most_characters() const;

  Quantity quantity_;
  Range range_;
  DisplayUnit unit_;
  Units units_;
  bool own_unit_ = false;
  double value_ = 0;
  QString unlimited_ = QStringLiteral("∞");
  QTimer gesture_end_;
};

}  // namespace toolpace::ui
