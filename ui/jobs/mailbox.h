#pragma once
/// What one thread leaves for another to do in its event loop.

#include <QSocketNotifier>
#include <deque>
#include <functional>
#include <mutex>

namespace toolpace::ui {

/// A queue of things to do: any thread posts them, the one that made the mailbox does them, in that order, each in its own turn
/// of the event loop. What is left when the mailbox goes is never done.
///
/// Qt could carry them, too, as events. But it is not built with ThreadSanitizer, which would then see no order between who
/// posts and who does; here it sees a mutex, and nothing of Qt is touched by who posts.
class Mailbox {
 public:
  using Letter = std::function<void()>;

  /// Throws std::system_error where the system has no descriptor left.
  Mailbox();
  ~Mailbox();
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  /// From any thread.
  void post(Letter letter);

 private:
  void open_one();

  const int bell_;  ///< an eventfd that counts letters
  std::mutex mutex_;
  std::deque<Letter> letters_;
  QSocketNotifier notifier_;
};

}  // namespace toolpace::ui
