#include "panels/nc_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

namespace toolpace::ui {

NcPanel::NcPanel(QWidget* parent)
    : QWidget(parent),
      change_bar_(new ChangeBar("changeBar", this)),
      view_(new NcView(this)),
      modal_(new ModalStrip(this)),
      bar_(new QWidget(this)),
      text_(new QLineEdit(bar_)),
      none_(new QLabel(bar_)),
      hint_(new QLabel(this)) {
  setObjectName("ncPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout(bar_);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(text_, 1);
  row->addWidget(none_);
  text_->setObjectName("findEdit");
  text_->setClearButtonEnabled(true);
  text_->installEventFilter(this);
  none_->setProperty("role", "error");
  none_->hide();
  bar_->hide();
  column->addWidget(change_bar_);
  column->addWidget(bar_);
  column->addWidget(view_, 1);
  column->addWidget(modal_);
  hint_->setObjectName("dropHint");
  hint_->setProperty("role", "hint");
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setContentsMargins(8, 8, 8, 8);
  hint_->hide();
  column->addWidget(hint_);
  setFocusProxy(view_);
  connect(view_, &NcView::currentLineChanged, this, &NcPanel::showModal);
  connect(view_, &NcView::findRequested, this, &NcPanel::openFindBar);
  connect(text_, &QLineEdit::textChanged, this, [this] { none_->hide(); });
  retranslate();
}

void NcPanel::showPlans(const Planned& plan, const Planned&) {
  if (plan.timeline == timeline_) return;
  timeline_ = plan.timeline;
  view_->setTimeline(plan.timeline, plan ? plan.scene->range(ColourBy::speed).high : 0);
}

void NcPanel::setLengthUnit(LengthUnit unit) { view_->setUnit(unit); }

void NcPanel::setTheme(const Theme& theme) {
  view_->setTheme(theme);
  modal_->setTheme(theme);
}

void NcPanel::showModal(int line) {
  const auto& document = view_->document();
  modal_->setSnapshot(document ? document->reading->modal.at(static_cast<std::size_t>(line)) : std::nullopt);
}

void NcPanel::openFindBar() {
  bar_->show();
  text_->setFocus();
  text_->selectAll();
}

void NcPanel::setHintVisible(bool visible) { hint_->setVisible(visible); }

void NcPanel::find(bool backwards) { none_->setVisible(!view_->findNext(text_->text(), backwards)); }

bool NcPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != text_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
    find(key->modifiers() & Qt::ShiftModifier);
    return true;
  }
  if (key->key() == Qt::Key_Escape) {
    bar_->hide();
    view_->setFocus();
    return true;
  }
  return false;
}

void NcPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void NcPanel::retranslate() {
  text_->setPlaceholderText(tr("Find"));
  text_->setAccessibleName(tr("Find in program"));
  none_->setText(tr("not found"));
  view_->setAccessibleName(tr("NC program"));
  hint_->setText(tr("drop an NC program here"));
  view_->setEmptyHint(tr("drop an NC program here"));
}

}  // namespace toolpace::ui
