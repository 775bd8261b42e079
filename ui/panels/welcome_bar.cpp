#include "panels/welcome_bar.h"

#include <QEvent>

#include "theme/control_name.h"
#include "theme/flow_layout.h"
#include "theme/icons.h"

namespace toolpace::ui {

WelcomeBar::WelcomeBar(QWidget* parent) : QWidget(parent), text_(new QLabel(this)), close_(new QToolButton(this)) {
  setObjectName("welcomeBar");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new FlowLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(8);
  text_->setObjectName("welcomeText");
  row->addWidget(text_);
  constexpr std::array names = {"tryJerk", "tryTolerance", "tryOpen"};
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i] = new QPushButton(this);
    buttons_[i]->setObjectName(names[i]);
    row->addWidget(buttons_[i]);
    connect(buttons_[i], &QPushButton::clicked, this, [this, i] { emit tried(static_cast<Try>(i)); });
  }
  close_->setObjectName("welcomeClose");
  close_->setAutoRaise(true);
  close_->setIconSize({16, 16});
  row->addWidget(close_);
  row->setAlignment(close_, Qt::AlignRight | Qt::AlignVCenter);
  connect(close_, &QToolButton::clicked, this, &WelcomeBar::dismissed);
  retranslate();
}

void WelcomeBar::setTheme(const Theme& theme) { close_->setIcon(icon("cancel", theme)); }

void WelcomeBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void WelcomeBar::retranslate() {
  text_->setText(tr("An example. Try:"));
  const auto name = [](QAbstractButton* button, const QString& text, const QString& tip) {
    if (qobject_cast<QPushButton*>(button)) button->setText(text);
    name_control(button, text, tip);
  };
  name(buttons_[0], tr("Less jerk"),
       tr("Put the cursor into the jerk limit: the arrow keys change it, and all follows"));
  name(buttons_[1], tr("Rounded corners"), tr("Pin this plan as B, and plan the fastest motion inside the tolerance"));
  name(buttons_[2], tr("Your program…"), tr("Open a program of your own; it can be dropped here as well"));
  name(close_, tr("Close"), tr("Do not show this again"));
}

}  // namespace toolpace::ui
