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

const Json* Json::find(std::string_view dotted) const {
  const Json* at = this;
  while (at) {
    const auto* members = std::get_if<Object>(&at->value_);
    if (!members) return nullptr;
    const std::size_t dot = std::min(dotted.find('.'), dotted.size());
    const auto found = std::find_if(members->begin(), members->end(),
                                    [&](const Member& m) { return m.first == dotted.substr(0, dot); });
    at = found == members->end() ? nullptr : &found->second;
    if (dot == dotted.size()) return at;
    dotted.remove_prefix(dot + 1);
  }
  return nullptr;
}

std::optional<double> Json::number() const {
  if (const auto* value = std::get_if<double>(&value_)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&value_)) return static_cast<double>(*value);
  return std::nullopt;
}

std::size_t Json::size() const {
  if (const auto* values = std::get_if<Array>(&value_)) return values->size();
  if (const auto* members = std::get_if<Object>(&value_)) return members->size();
  return 0;
}

std::string Json::line() const {
  std::string out;
  if (const auto* text = std::get_if<std::string>(&value_)) return *text;
  if (const auto* values = std::get_if<Array>(&value_)) {
    for (const Json& value : *values) out += (out.empty() ? "" : "; ") + value.line();
    return out;
  }
  if (const auto* members = std::get_if<Object>(&value_)) {
    for (const Member& m : *members) out += (out.empty() ? "" : " ") + m.first + ' ' + m.second.line();
    return out;
  }
  return is_null() ? out : text();
}

std::string Json::text() const {
  std::string out;
  std::visit(JsonWriter{out}, value_);
  return out;
}

}  // namespace toolpace::cli
