#pragma once
/// JSON values to print.
///
/// The library that writes them stays in json.cpp: its header takes longer to compile than a command.

#include <cmath>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace toolpace::cli {

/// Null, a boolean, a number, a text, an array, or an object whose members keep their order.
class Json {
 public:
  using Member = std::pair<std::string, Json>;
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;

  Json() = default;  ///< null
  Json(std::nullptr_t) {}
  Json(double value) {
    if (std::isfinite(value)) value_ = value;  // a number that does not exist is null
  }
  template <std::integral T>
  Json(T value) {
    if constexpr (std::same_as<T, bool>) {
      value_ = value;
    } else if constexpr (std::signed_integral<T>) {
      value_ = static_cast<std::int64_t>(value);
    } else {
      value_ = static_cast<std::uint64_t>(value);
    }
  }
  Json(const char* text) : value_(std::string(text)) {}
  Json(std::string_view text) : value_(std::string(text)) {}
  Json(std::string text) : value_(std::move(text)) {}
  template <class T>
  Json(const std::optional<T>& value) {
    if (value) *this = Json(*value);
  }
  Json(const std::vector<std::string>& texts) : value_(Array(texts.begin(), texts.end())) {}
  Json(std::initializer_list<Member> members) : value_(Object(members)) {}

  static Json array() { return Json(Array{}); }
  static Json object() { return Json(Object{}); }

  /// The member of this name, made where there is none. A null becomes an object.
  Json& operator[](std::string_view key);
  /// A null becomes an array.
  void push_back(Json value);

  /// What stands at "best.settings": members of members. Null pointer where there is none.
  const Json* find(std::string_view dotted) const;
  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
  std::optional<double> number() const;  ///< nothing where it is none
  std::size_t size() const;              ///< of an array or object; else 0
  /// On one line for people and tables: a text as it is, numbers that read back to the same double, nothing of null,
  /// "a; b" of an array, "key value" of the members of an object with blanks between.
  std::string line() const;

  /// Two blanks a level. Texts may hold any bytes; what is no UTF-8 becomes U+FFFD.
  std::string text() const;

 private:
  friend struct JsonWriter;
  explicit Json(Array values) : value_(std::move(values)) {}
  explicit Json(Object members) : value_(std::move(members)) {}

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> value_;
};

}  // namespace toolpace::cli
