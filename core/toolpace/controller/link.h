#pragma once
/// A serial link with a sender that counts characters: it fills the controller's receive buffer, and no more.

#include <algorithm>
#include <cstdint>
#include <deque>

namespace toolpace::detail::controller {

class Link {
 public:
  /// @param bytes_per_second  > 0
  /// @param room  bytes of the receive buffer that a sender uses
  Link(double bytes_per_second, std::size_t room) : second_a_byte_(1.0 / bytes_per_second), room_(room) {}

  /// The next line of the program. @return when its last byte has come [s]
  double receive(std::size_t bytes) {
    while (outstanding_ + bytes > room_ && !lines_.empty()) {
      free_ = std::max(free_, lines_.front().read);
      outstanding_ -= lines_.front().bytes;
      lines_.pop_front();
    }
    free_ += static_cast<double>(bytes) * second_a_byte_;
    outstanding_ += bytes;
    lines_.push_back({bytes, free_});
    return free_;
  }

  /// When the controller took that line out of its buffer [s].
  void set_read(double when) { lines_.back().read = when; }

 private:
  struct Line {
    std::size_t bytes;
    double read;
  };
  double second_a_byte_;
  std::size_t room_;
  double free_ = 0;  ///< [s] when the wire has nothing to do
  std::size_t outstanding_ = 0;
  std::deque<Line> lines_;
};

}  // namespace toolpace::detail::controller
