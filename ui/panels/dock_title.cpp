#include "panels/dock_title.h"

#include <QDockWidget>
#include <QEvent>
#include <QStyle>
#include <algorithm>

#include "theme/control_name.h"
#include "theme/icons.h"

namespace toolpace::ui {
namespace {

constexpr int kHeight = 28;

}  // namespace

DockTitle::DockTitle(QDockWidget* dock, bool when_docked)
    : QWidget(dock),
      when_docked_(when_docked),
      title_(new QLabel(this)),
      badge_(new QLabel(this)),
      row_(new QHBoxLayout(this)) {
  setProperty("role", "dockTitle");
  setAttribute(Qt::WA_StyledBackground);
  row_->setContentsMargins(8, 0, 4, 0);
  row_->setSpacing(4);
  title_->setProperty("role", "heading");
  badge_->setProperty("role", "warning");
  badge_->setObjectName(dock->objectName() + "Badge");
  badge_->hide();
  row_->addWidget(title_);
  row_->addWidget(badge_);
  row_->addStretch(1);
  dock_ = addButton(dock->objectName() + "Dock", "panels");
  close_ = addButton(dock->objectName() + "Close", "cancel");
  connect(dock_, &QToolButton::clicked, dock, [dock] { dock->setFloating(false); });
  connect(close_, &QToolButton::clicked, dock, &QDockWidget::close);
  connect(dock, &QDockWidget::topLevelChanged, this, &DockTitle::showButtons);
  connect(dock, &QDockWidget::windowTitleChanged, title_, &QLabel::setText);
  retranslate();
  showButtons(false);
}

QToolButton* DockTitle::addButton(const QString& name, const char* icon_name) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setAutoRaise(true);
  button->setIconSize({16, 16});
  button->setProperty("icon_name", icon_name);
  row_->addWidget(button);
  return button;
}

void DockTitle::setTheme(const Theme& theme) {
  for (auto* button : {dock_, close_}) button->setIcon(icon(button->property("icon_name").toString(), theme));
}

void DockTitle::showButtons(bool floating) {
  floating_ = floating;
  for (auto* button : {dock_, close_}) button->setVisible(floating);
  setFixedHeight(wantedHeight());
  updateGeometry();
}

void DockTitle::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::StyleChange) setFixedHeight(wantedHeight());
  QWidget::changeEvent(event);
}

void DockTitle::retranslate() {
  name_control(dock_, tr("Put the panel back into the window"));
  name_control(close_, tr("Close the panel"));
}

void DockTitle::setBadge(const QString& text, const QString& tip, Badge kind) {
  const QString role = kind == Badge::warning ? "warning" : "secondary";
  if (badge_->property("role") != role) {
    badge_->setProperty("role", role);
    badge_->style()->unpolish(badge_);
    badge_->style()->polish(badge_);
  }
  badge_->setText("· " + text);
  badge_->setToolTip(tip);
  badge_->setVisible(!text.isEmpty());
}

int DockTitle::wantedHeight() const {
  if (!floating_) return when_docked_ ? kHeight : 0;
  return std::max(kHeight, close_->sizeHint().height() + 4);
}

QSize DockTitle::sizeHint() const { return {QWidget::sizeHint().width(), wantedHeight()}; }

QSize DockTitle::minimumSizeHint() const {
  return {floating_ || when_docked_ ? QWidget::minimumSizeHint().width() : 0, wantedHeight()};
}

}  // namespace toolpace::ui
