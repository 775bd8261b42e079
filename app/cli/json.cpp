#include "json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace toolpace::cli {

using Library = nlohmann::ordered_json;

/// Hands a value over to the library that prints it.
struct JsonWriter {
  static Library convert(const Json& json) { return std::visit(JsonWriter{}, json.value_); }

  template <class T>
  Library operator()(const T& scalar) const {
    return Library(scalar);
  }
  Library operator()(const Json::Array& values) const {
    Library array = Library::array();
    for (const Json& value : values) array.push_back(convert(value));
    return array;
  }
  Library operator()(const Json::Object& members) const {
    Library object = Library::object();
    for (const auto& [key, value] : members) object[key] = convert(value);
    return object;
  }
};

Json& Json::operator[](std::string_view key) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Object{};
  auto& members = std::get<Object>(value_);
  const auto found = std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.first == key; });
  if (found != members.end()) return found->second;
  return members.emplace_back(std::string(key), Json()).second;
}

void Json::push_back(Json value) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Array{};
  std::get<Array>(value_).push_back(std::move(value));
}

std::string Json::text() const {
  constexpr int kIndent = 2;
  return JsonWriter::convert(*this).dump(kIndent, ' ', false, Library::error_handler_t::replace);
}

}  // namespace toolpace::cli
