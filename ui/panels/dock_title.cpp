#include "panels/dock_title.h"

#include <QStyle>

namespace toolpace::ui {
namespace {

constexpr int kHeight = 28;

}  // namespace

DockTitle::DockTitle(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), badge_(new QLabel(this)), row_(new QHBoxLayout(this)) {
  setProperty("role", "dockTitle");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(kHeight);
  row_->setContentsMargins(8, 0, 4, 0);
  row_->setSpacing(4);
  title_->setProperty("role", "heading");
  badge_->setProperty("role", "warning");
  badge_->setObjectName(parent->objectName() + "Badge");
  badge_->hide();
  row_->addWidget(title_);
  row_->addWidget(badge_);
  row_->addStretch(1);
}

void DockTitle::setTitle(const QString& title) { title_->setText(title); }

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

QSize DockTitle::sizeHint() const { return {QWidget::sizeHint().width(), kHeight}; }

QSize DockTitle::minimumSizeHint() const { return {QWidget::minimumSizeHint().width(), kHeight}; }

}  // namespace toolpace::ui
