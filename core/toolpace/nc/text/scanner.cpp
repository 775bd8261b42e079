#include "toolpace/nc/text/scanner.h"

#include <charconv>
#include <cmath>
#include <string>

namespace toolpace::nc {
namespace {

// Powers of ten that doubles hold exactly: dividing an integer below 2^53 by one of them rounds once, hence correctly.
constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
constexpr int kMostDigits = 15;  // 10^15 < 2^53

}  // namespace

NumberStatus Scanner::take_unsigned(double& value) {
  const char* const start = at_;
  std::uint64_t mantissa = 0;
  int digits = 0;
  int decimals = 0;
  bool point = false;
  const char* p = at_;
  for (; p != end_; ++p) {
    const char c = *p;
    if (is_digit(c)) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
      ++digits;
      decimals += point ? 1 : 0;
    } else if (c == '.') {
      if (point) break;
      point = true;
    } else {
      break;
    }
  }
  const bool blank_follows = p != end_ && detail::kFold[static_cast<unsigned char>(*p)] == detail::kBlank;
  if (blank_follows) {
    at_ = p;
    const char c = peek();
    if (is_digit(c) || c == '.') return take_long(start, value);  // "0 2 . 5" is one number
  }
  if (digits > kMostDigits || mantissa >= kExactIntegers) return take_long(start, value);
  at_ = p;
  if (p != end_ && *p == '.') return NumberStatus::two_points;
  if (digits == 0) {
    at_ = start;
    return NumberStatus::none;
  }
  value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  return NumberStatus::ok;
}

NumberStatus Scanner::take_long(const char* start, double& value) {
  at_ = start;
  std::string text;
  bool point = false;
  for (char c = peek(); is_digit(c) || c == '.'; c = peek()) {
    if (c == '.') {
      if (point) return NumberStatus::two_points;
      point = true;
    }
    text.push_back(c);
    take();
  }
  if (text.empty() || text == ".") return NumberStatus::none;
  if (text.front() == '.') text.insert(text.begin(), '0');
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (result.ec == std::errc::result_out_of_range) {
    // Too small reads as zero, too large is an error.
    if (text.find_first_not_of("0.") != std::string::npos && text.find('.') > 1) return NumberStatus::too_large;
    value = 0.0;
  }
  return std::isfinite(value) ? NumberStatus::ok : NumberStatus::too_large;
}

}  // namespace toolpace::nc
