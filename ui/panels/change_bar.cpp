#include "panels/change_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace toolpace::ui {

ChangeBar::ChangeBar(const QString& name, QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), take_file_(new QPushButton(this)), keep_mine_(new QPushButton(this)) {
  setObjectName(name);
  setProperty("role", "question");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(8);
  text_->setObjectName(name + "Text");
  text_->setWordWrap(true);
  column->addWidget(text_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  keep_mine_->setObjectName(name + "KeepMine");
  take_file_->setObjectName(name + "TakeFile");
  row->addWidget(keep_mine_);
  row->addWidget(take_file_);
  row->addStretch(1);
  column->addLayout(row);
  connect(take_file_, &QPushButton::clicked, this, &ChangeBar::takeFileRequested);
  connect(keep_mine_, &QPushButton::clicked, this, &ChangeBar::keepMineRequested);
  hide();
  retranslate();
}

void ChangeBar::ask(Reason reason) {
  reason_ = reason;
  retranslate();
  show();
}

void ChangeBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ChangeBar::retranslate() {
  switch (reason_) {
    case Reason::reload:
      text_->setText(tr("Your changes are not saved. Reading the file again puts them aside."));
      break;
    case Reason::changed_outside:
      text_->setText(tr("The file was changed by another program, and your changes are not saved."));
      break;
    case Reason::machine_changed_outside:
      text_->setText(tr("The machine file was changed by another program, and your changes are not saved."));
      break;
    case Reason::settings_changed_outside:
      text_->setText(tr("The settings file was changed by another program, and your changes are not saved."));
      break;
  }
  const bool has_values = reason_ == Reason::machine_changed_outside || reason_ == Reason::settings_changed_outside;
  keep_mine_->setText(tr("Keep mine"));
  keep_mine_->setToolTip(has_values ? tr("Stay with the values in the window; saving puts them into the file")
                                    : tr("Stay with the text in the window; saving it replaces the file"));
  take_file_->setText(tr("Take the file's"));
  take_file_->setToolTip(tr("Read the file again; undo brings your changes back"));
}

}  // namespace toolpace::ui
