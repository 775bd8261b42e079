#pragma once
/// Which of the states that undo and redo go through is the one that was saved.

#include <QtGlobal>

namespace toolpace::ui {

/// Numbers for the states of something that is edited, undone and saved: the same number means the same content. One undo
/// stack serves several such things, so its own clean mark cannot tell which of them was saved.
struct EditState {
  quint64 now = 0;
  quint64 saved = 0;
  quint64 newest = 0;

  /// Of a content that was not there before.
  quint64 fresh() { return ++newest; }
  bool is_saved() const { return now == saved; }
  /// Nothing that can be gone back to is what was saved.
  void forget_saved() { saved = fresh(); }
};

}  // namespace toolpace::ui
