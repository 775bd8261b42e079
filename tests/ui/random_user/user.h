#pragma once
/// Somebody who does anything at all with the window, and looks after each step whether it still makes sense.

#include <memory>

#include "main_window.h"
#include "random_user/desk.h"

namespace toolpace::ui {

class RandomUser {
 public:
  explicit RandomUser(std::uint64_t seed);

  /// Does one thing. @return what, in words
  QString act();

  /// What is wrong with the window as it stands; empty = nothing.
  QString trouble();
  /// Waits until nothing goes on any more; then nothing may be left over, and undoing everything and doing it again has to
  /// come back to where it began. @return what is wrong; empty = nothing
  QString deep_trouble();

 private:
  QString use_files();
  QString use_actions();
  QString use_workspace();
  QString use_window();
  bool comes_to_rest();
  QString undo_trouble();
  std::string tuning() const;

  Chance chance_;
  Desk desk_;
  std::unique_ptr<studio::MainWindow> window_;
};

}  // namespace toolpace::ui
