#pragma once
/// A cursor over one line of RS-274 text: blanks vanish, letters fold to lower case, numbers are read fast and exactly.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace toolpace::nc {

namespace detail {

/// Lower-case letter, or the character itself; blanks (space, tab, return, …) fold to kBlank.
inline constexpr char kBlank = 1;

constexpr std::array<char, 256> make_fold_table() {
  std::array<char, 256> table{};
  for (std::size_t c = 0; c < table.size(); ++c) table[c] = static_cast<char>(c);
  for (std::size_t c = 'A'; c <= 'Z'; ++c) table[c] = static_cast<char>(c - 'A' + 'a');
  for (const char c : {' ', '\t', '\r', '\v', '\f'}) table[static_cast<unsigned char>(c)] = kBlank;
  for (const std::size_t c : {0x11u, 0x12u, 0x13u, 0x14u, 0x1Au, 0x7Fu})
    table[c] = kBlank;  // device controls, DOS's end of file, what is rubbed out on tapes
  return table;
}
inline constexpr std::array<char, 256> kFold = make_fold_table();

}  // namespace detail

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

/// What senders pass to the controller at once, wherever it stands.
constexpr bool is_real_time(char c) { return c == '?' || c == '!' || c == '~'; }

enum class NumberStatus : std::uint8_t { ok, none, two_points, too_large };

class Scanner {
 public:
  explicit Scanner(std::string_view line) : begin_(line.data()), at_(begin_), end_(begin_ + line.size()) {}

  /// The next significant character, lower-cased; '\0' at the end of the line.
  char peek() {
    while (at_ != end_) {
      const char c = detail::kFold[static_cast<unsigned char>(*at_)];
      if (c != detail::kBlank) return c;
      ++at_;
    }
    return '\0';
  }

  /// The significant character after the next one.
  char peek_second() {
    Scanner ahead = *this;
    ahead.peek();
    ahead.take();
    return ahead.peek();
  }

  /// Steps over the character that peek() returned.
  void take() {
    if (at_ != end_) ++at_;
  }

  /// Takes `word` (lower case) if it comes next, blanks or not between its letters.
  bool take_word(std::string_view word) {
    Scanner ahead = *this;
    for (const char c : word) {
      if (ahead.peek() != c) return false;
      ahead.take();
    }
    at_ = ahead.at_;
    return true;
  }

  /// Reads [+-]digits[.digits]. An exponent is not part of a number in NC programs.
  /// Accuracy: the double nearest to the decimal text.
  NumberStatus take_number(double& value) {
    const char first = peek();
    bool negative = false;
    if (first == '-' || first == '+') {
      negative = first == '-';
      ++at_;
    }
    const NumberStatus status = take_unsigned(value);
    if (negative) value = -value;
    return status;
  }

  const char* position() const { return at_; }
  void move_to(const char* position) { at_ = position; }
  const char* end() const { return end_; }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
  std::string_view line() const { return {begin_, static_cast<std::size_t>(end_ - begin_)}; }

  /// Column of the cursor, from 1.
  std::size_t column() const { return static_cast<std::size_t>(at_ - begin_) + 1; }

 private:
  NumberStatus take_unsigned(double& value);
  NumberStatus take_long(const char* start, double& value);

  const char* begin_;
  const char* at_;
  const char* end_;
};

}  // namespace toolpace::nc
