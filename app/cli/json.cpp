#include "json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace toolpace::cli {

using Library = nlohmann::ordered_json;

/// Lays out arrays and objects; what stands in them is written by the library. It is given no more than one value at a time:
/// taking a tree of its down needs memory, and where there is none left, that ends the program.
struct JsonWriter {
  std::string& out;
  std::size_t depth = 0;

  template <class T>
  void operator()(const T& scalar) const {
    out += Library(scalar).dump(-1, ' ', false, Library::error_handler_t::replace);
  }
  void operator()(const Json::Array& values) const {
    write_list('[', values, ']', [](const JsonWriter& inner, const Json& value) { std::visit(inner, value.value_); });
  }
  void operator()(const Json::Object& members) const {
    write_list('{', members, '}', [](const JsonWriter& inner, const Json::Member& member) {
      inner(member.first);
      inner.out += ": ";
      std::visit(inner, member.second.value_);
    });
  }

 private:
  template <class List, class Write>
  void write_list(char open, const List& list, char close, const Write& write) const {
    out += open;
    const JsonWriter inner{out, depth + 1};
    for (const auto& entry : list) {
      if (&entry != &list.front()) out += ',';
      inner.new_line();
      write(inner, entry);
    }
    if (!list.empty()) new_line();
    out += close;
  }
  void new_line() const {
    constexpr std::size_t kIndent = 2;
    out += '\n';
    out.append(kIndent * depth, ' ');
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
  std::string out;
  std::visit(JsonWriter{out}, value_);
  return out;
}

}  // namespace toolpace::cli
