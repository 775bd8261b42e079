#pragma once
/// The look-ahead depth: a logarithmic slider, an exact entry and "all", three views of one value.

#include <QSlider>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "panels/number_field.h"

namespace toolpace::ui {

class LookaheadField : public QWidget {
  Q_OBJECT

 public:
  explicit LookaheadField(QWidget* parent = nullptr);

  void setValue(std::optional<std::size_t> depth);  ///< none = all
  std::optional<std::size_t> value() const { return depth_; }
  /// The slider's right end; deeper values can still be typed.
  void setBlockCount(std::size_t blocks);
  void retranslate();

 signals:
  void edited(std::optional<std::size_t> depth);
  void gestureStarted();
  void gestureFinished();

 private:
  void take(std::optional<std::size_t> depth);
  void show_value();
  int position_of(std::optional<std::size_t> depth) const;
  std::optional<std::size_t> depth_at(int position) const;

  QSlider* slider_;
  NumberField* field_;
  QToolButton* all_;
  std::optional<std::size_t> depth_;
  std::size_t most_ = 1000;     ///< depth just left of "all"
  std::size_t before_all_ = 8;  ///< what unchecking "all" goes back to
};

}  // namespace toolpace::ui
