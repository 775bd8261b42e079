#include "panels/dock_title.h"

#include <QEvent>

namespace toolpace::ui {
namespace {

constexpr int kHeight = 28;

}  // namespace

DockTitle::DockTitle(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), stale_(new QLabel(this)), row_(new QHBoxLayout(this)) {
  setProperty("role", "dockTitle");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(kHeight);
  row_->setContentsMargins(8, 0, 4, 0);
  row_->setSpacing(4);
  title_->setProperty("role", "heading");
  stale_->setProperty("role", "warning");
  stale_->setObjectName("staleBadge");
  stale_->hide();
  row_->addWidget(title_);
  row_->addWidget(stale_);
  row_->addStretch(1);
}

void DockTitle::setTitle(const QString& title) { title_->setText(title); }

void DockTitle::setStale(bool stale) {
  stale_->setText("· " + tr("stale"));
  stale_->setToolTip(tr("The plan shown is not yet the one of these parameters"));
  stale_->setVisible(stale);
}

void DockTitle::addControl(QWidget* control) { row_->addWidget(control); }

QSize DockTitle::sizeHint() const { return {QWidget::sizeHint().width(), kHeight}; }

QSize DockTitle::minimumSizeHint() const { return {QWidget::minimumSizeHint().width(), kHeight}; }

void DockTitle::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) setStale(stale_->isVisibleTo(this));
  QWidget::changeEvent(event);
}

}  // namespace toolpace::ui
