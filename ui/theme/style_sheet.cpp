#include "theme/style_sheet.h"

#include <QHash>

#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

// $name stands for a token. Heights are of the content; borders and padding come on top.
constexpr auto kSheet = R"(
* { outline: none; }
QMainWindow, QDialog { background: $window; }
QMainWindow::separator { background: $line; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: $accent; }
QToolTip { background: $surface; color: $text; border: 1px solid $line; padding: 4px 8px; }

QMenuBar { background: $surface; color: $text; border-bottom: 1px solid $line; padding: 0 4px; }
QMenuBar::item { padding: $menuPad 8px; background: transparent; }
QMenuBar::item:selected { background: $hover; }
QMenu { background: $surface; color: $text; border: 1px solid $line; padding: 4px 0; }
QMenu::item { padding: $menuPad 28px $menuPad 28px; min-height: $itemHeight; }
QMenu::item:selected { background: $hover; color: $text; }
QMenu::item:disabled { color: $faint; }
QMenu::separator { height: 1px; background: $line; margin: 4px 0; }

QToolBar { background: $surface; border: none; border-bottom: 1px solid $line; padding: 0 8px; spacing: 4px; }
QToolBar QMenuBar { border: none; padding: 0; }
QToolBar::separator { background: $line; width: 1px; margin: 6px 4px; }
QStatusBar { background: $surface; border-top: 1px solid $line; }
QStatusBar::item { border: none; }

QDockWidget { color: $secondary; titlebar-close-icon: none; titlebar-normal-icon: none; }
QDockWidget > QWidget { background: $surface; }
QTabBar { background: $surface; qproperty-drawBase: 0; }
QTabBar::tab { background: $surface; color: $secondary; border: none; border-bottom: 2px solid transparent;
  padding: 4px 5px; min-height: $tabHeight; }
QTabBar::tab:selected { color: $text; border-bottom: 2px solid $accent; }
QTabBar::tab:hover { color: $text; }
QTabBar::tab:focus { border-bottom: 2px solid $accent; background: $hover; }

QToolButton { background: transparent; color: $text; border: 1px solid transparent; border-radius: 4px; padding: 3px 6px;
  min-height: $buttonHeight; }
QToolButton:hover { background: $hover; }
QToolButton:pressed, QToolButton:checked { background: $pressed; }
QToolButton:focus { border-color: $accent; }
QToolButton:disabled { color: $faint; }
QToolButton[popupMode="2"] { padding-right: 16px; }
QToolButton::menu-button { border: none; width: 16px; border-radius: 4px; }
QToolButton::menu-button:hover { background: $pressed; }
QToolButton::menu-arrow { image: url(:/icons/chevron-down.svg); width: 10px; height: 10px; }
QToolButton[popupMode="1"] { padding-right: 20px; }
QToolButton::menu-indicator { image: url(:/icons/chevron-down.svg); width: 10px; height: 10px;
  subcontrol-origin: padding; subcontrol-position: right center; right: 4px; }

QPushButton { background: $surface; color: $text; border: 1px solid $line; border-radius: 4px; padding: 3px 12px;
  min-height: $buttonHeight; }
QPushButton:hover { background: $hover; }
QPushButton:pressed, QPushButton:checked { background: $pressed; }
QPushButton:focus { border-color: $accent; }
QPushButton:default { border-color: $accent; }
QPushButton:disabled { color: $faint; }

QLineEdit, QAbstractSpinBox, QComboBox { background: $surface; color: $text; border: 1px solid $line; border-radius: 4px;
  padding: 1px 6px; min-height: $fieldHeight; selection-background-color: $accent; selection-color: $onAccent; }
QLineEdit:hover, QAbstractSpinBox:hover, QComboBox:hover { border-color: $faint; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border-color: $accent; }
QLineEdit[wrong="true"], QLineEdit[wrong="true"]:focus { border-color: $error; color: $error; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { color: $faint; background: $window; }
QAbstractSpinBox QLineEdit, QTableView QLineEdit { border: none; border-radius: 0; padding: 0; min-height: 0; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/icons/chevron-down.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: $surface; color: $text; border: 1px solid $line; padding: 4px 0;
  selection-background-color: $hover; selection-color: $text; }
QComboBox QAbstractItemView::item { min-height: $itemHeight; padding: 0 8px; }

QCheckBox { spacing: 8px; min-height: $fieldHeight; color: $text; }
QCheckBox::indicator { width: $check; height: $check; border: 1px solid $faint; border-radius: 3px; background: $surface; }
QCheckBox::indicator:checked { background: $accent; border-color: $accent; image: url($checkIcon); }
QCheckBox:focus { color: $accent; }
QCheckBox:disabled { color: $faint; }

QSlider { background: transparent; min-height: $sliderHeight; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: $line; }
QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: $accent; }
QSlider::handle:horizontal { width: $knob; height: $knob; margin: $knobMargin 0; border-radius: $knobRadius;
  background: $surface; border: 2px solid $accent; }
QSlider::handle:horizontal:hover, QSlider::handle:horizontal:focus { background: $accent; }
QSlider::sub-page:horizontal:disabled { background: $line; }
QSlider::handle:horizontal:disabled { border-color: $line; }

QProgressBar { background: $line; border: none; border-radius: 2px; max-height: 4px; min-height: 4px; }
QProgressBar::chunk { background: $accent; border-radius: 2px; }

QScrollArea { background: $surface; border: none; }
QAbstractScrollArea { border: none; }
QTableView, QTreeView, QListView { background: $surface; color: $text; border: none; alternate-background-color: $stripe;
  selection-background-color: $pressed; selection-color: $text; gridline-color: $line; }
QTableView::item { padding: 0 6px; border: none; }
QTableView::item:focus { background: $hover; }
QHeaderView { background: $surface; }
QHeaderView::section { background: $surface; color: $secondary; border: none; border-bottom: 1px solid $line; padding: 4px 8px; }
QHeaderView::section:vertical { padding: 0 8px; border: none; color: $text; }
QHeaderView::section:hover { color: $text; }
QHeaderView::down-arrow { image: url(:/icons/chevron-down.svg); width: 10px; height: 10px; }
QHeaderView::up-arrow { image: url(:/icons/chevron-up.svg); width: 10px; height: 10px; }
QTableCornerButton::section { background: $surface; border: none; border-bottom: 1px solid $line; }

QScrollBar:vertical { background: transparent; width: $scroll; margin: 0; }
QScrollBar:horizontal { background: transparent; height: $scroll; margin: 0; }
QScrollBar::handle { background: $line; border-radius: 3px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 32px; }
QScrollBar::handle:horizontal { min-width: 32px; }
QScrollBar::handle:hover { background: $faint; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QLabel { color: $text; background: transparent; }
QLabel[role="secondary"] { color: $secondary; }
QLabel[role="heading"] { color: $secondary; font-weight: 600; }
QLabel[role="hint"] { color: $secondary; background: $surface; border-top: 1px solid $line; }
QLabel[role="warning"] { color: $warning; }
QLabel[role="error"] { color: $error; }
QLabel[role="good"] { color: $good; }
QFrame[role="line"] { background: $line; border: none; max-height: 1px; min-height: 1px; }
QWidget[role="surface"] { background: $surface; }
QWidget[role="question"] { background: $window; border: none; border-left: 3px solid $warning; }
QWidget[role="dockTitle"] { background: $surface; border-bottom: 1px solid $line; }
)";

QHash<QString, QString> tokens_of(const Theme& t, bool touch) {
  const auto px = [](int value) { return QString::number(value) + "px"; };
  const int knob = touch ? 28 : 12;
  return {{"window", t.window.name()},
          {"surface", t.surface.name()},
          {"line", t.line.name()},
          {"text", t.text.name()},
          {"secondary", t.secondary.name()},
          {"accent", t.accent.name()},
          {"onAccent", (t.dark ? t.window : t.surface).name()},
          {"warning", t.warning.name()},
          {"error", t.error.name()},
          {"good", t.good.name()},
          {"hover", mixed(t.surface, t.line, 0.5).name()},
          {"pressed", mixed(t.surface, t.accent, t.dark ? 0.28 : 0.14).name()},
          {"stripe", mixed(t.surface, t.window, 0.6).name()},
          {"faint", mixed(t.secondary, t.window, 0.4).name()},
          {"faintLine", mixed(t.surface, t.line, 0.5).name()},
          {"checkIcon", t.dark ? ":/icons/check-dark.svg" : ":/icons/check-light.svg"},
          {"menuPad", px(touch ? 12 : 4)},
          {"itemHeight", px(touch ? 40 : 20)},
          {"tabHeight", px(touch ? 40 : 18)},
          {"buttonHeight", px(touch ? 40 : 16)},
          {"fieldHeight", px(touch ? 44 : 18)},
          {"sliderHeight", px(touch ? 48 : 18)},
          {"check", px(touch ? 28 : 14)},
          {"scroll", px(touch ? 24 : 10)},
          {"knobRadius", px(knob / 2 + 2)},
          {"knobMargin", px(-(knob / 2))},
          {"knob", px(knob)}};
}

}  // namespace

QString style_sheet(const Theme& tokens, bool touch) {
  const auto values = tokens_of(tokens, touch);
  const QString source = QString::fromLatin1(kSheet);
  QString sheet;
  qsizetype at = 0;
  for (qsizetype mark = source.indexOf('$'); mark >= 0; mark = source.indexOf('$', at)) {
    qsizetype end = mark + 1;
    while (end < source.size() && source[end].isLetter()) ++end;
    sheet += source.mid(at, mark - at) + values.value(source.mid(mark + 1, end - mark - 1));
    at = end;
  }
  return sheet + source.mid(at);
}

}  // namespace toolpace::ui
