#include "jobs/mailbox.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

namespace toolpace::ui {
namespace {

int new_bell() {
  const int bell = ::eventfd(0, EFD_SEMAPHORE | EFD_NONBLOCK | EFD_CLOEXEC);
  if (bell < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  return bell;
}

}  // namespace

Mailbox::Mailbox() : bell_(new_bell()), notifier_(bell_, QSocketNotifier::Read) {
  QObject::connect(&notifier_, &QSocketNotifier::activated, &notifier_, [this] { open_one(); });
}

Mailbox::~Mailbox() {
  notifier_.setEnabled(false);
  ::close(bell_);
}

void Mailbox::post(Letter letter) {
  const std::lock_guard lock(mutex_);
  letters_.push_back(std::move(letter));
  ::eventfd_write(bell_, 1);
}

/// One letter for one ring: whatever it does, a nested event loop or the end of the mailbox, the others are not concerned.
void Mailbox::open_one() {
  eventfd_t rings = 0;
  if (::eventfd_read(bell_, &rings) != 0) return;  // a nested event loop was quicker
  Letter letter;
  {
    const std::lock_guard lock(mutex_);
    letter = std::move(letters_.front());
    letters_.pop_front();
  }
  letter();
}

}  // namespace toolpace::ui
