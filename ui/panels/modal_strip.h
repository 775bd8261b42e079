#pragma once
/// What is modal at the cursor line: active codes, work offset, tool, feed and spindle.

#include <QLabel>
#include <optional>

#include "theme/theme.h"
#include "toolpace/nc/modal_log.h"

namespace toolpace::ui {

/// Two quiet lines of text. Codes that differ from what a controller starts with stand out; the tooltip says what each
/// of them means.
class ModalStrip : public QLabel {
  Q_OBJECT

 public:
  explicit ModalStrip(QWidget* parent = nullptr);

  /// Nothing: hidden (polylines have no modal state).
  void setSnapshot(const std::optional<ModalSnapshot>& snapshot);
  void setTheme(const Theme& theme);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showSnapshot();
  QString codes() const;
  QString words() const;
  QString meanings() const;

  std::optional<ModalSnapshot> snapshot_;
  Theme theme_ = light_theme();
};

/// "G1", "G59.1" of a code in tenths.
QString code_text(std::int16_t tenths);

}  // namespace toolpace::ui
