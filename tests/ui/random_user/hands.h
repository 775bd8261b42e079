#pragma once
/// What a random user does to widgets: clicks, keys, wheels, drags, drops; and the answers to dialogs and menus.

#include <QTimer>
#include <QWidget>

#include "random_user/desk.h"

namespace toolpace::ui {

/// Answers whatever waits for an answer, at random, for as long as it lives: dialogs and menus run an event loop of their
/// own, in which the action that opened them would stay forever.
class Answers {
 public:
  Answers(const Desk& desk, Chance& chance);

 private:
  void answer();

  const Desk& desk_;
  Chance& chance_;
  QTimer timer_;
};

/// Each returns what it did, in words.
QString click_somewhere(QWidget& window, Chance& chance);
QString drag_somewhere(QWidget& window, Chance& chance);
QString turn_the_wheel(QWidget& window, Chance& chance);
QString press_a_key(QWidget& window, Chance& chance);
QString type_into_a_field(QWidget& window, Chance& chance);
QString choose_in_a_list(QWidget& window, Chance& chance);
QString drop_a_file(QWidget& window, const QString& path);

}  // namespace toolpace::ui
