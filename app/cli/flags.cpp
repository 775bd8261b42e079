#include "flags.h"

#include <charconv>
#include <functional>

namespace toolpace::cli {
namespace {

template <class T>
bool read_whole(const std::string& text, T& value) {
  const bool has_plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (has_plus ? 1 : 0), end, value);
  return error == std::errc() && stop == end;
}

using Take = std::function<bool(const std::string& text)>;

/// @param flag  "--name UNIT"
/// @param what  what `take` accepts, for people: "a number"
CLI::Option* add(CLI::App& command, const std::string& flag, const std::string& text, const char* what, Take take) {
  const std::size_t blank = flag.find(' ');
  const std::string name = flag.substr(0, blank);
  const auto read = [name, what, take = std::move(take)](const std::string& word) {
    if (take(word)) return;
    throw CLI::ValidationError(
        name, word.empty() ? "is empty; it takes " + std::string(what) : "'" + word + "' is not " + what);
  };
  return command.add_option_function<std::string>(name, read, text)
      ->type_name(blank == std::string::npos ? "" : flag.substr(blank + 1));
}

}  // namespace

CLI::Option* add_number(CLI::App& command, const std::string& flag, std::optional<double>& target,
                        const std::string& text) {
  return add(command, flag, text, "a number", [&target](const std::string& word) {
    double value = 0;
    if (!read_whole(word, value)) return false;
    target = value;
    return true;
  });
}

CLI::Option* add_number(CLI::App& command, const std::string& flag, double& target, const std::string& text) {
  return add(command, flag, text, "a number", [&target](const std::string& word) { return read_whole(word, target); });
}

CLI::Option* add_count(CLI::App& command, const std::string& flag, std::uint64_t& target, const std::string& text) {
  return add(command, flag, text, "a whole number of 0 or more",
             [&target](const std::string& word) { return read_whole(word, target); });
}

CLI::Option* add_word(CLI::App& command, const std::string& flag, std::string& target, const std::string& text) {
  return add(command, flag, text, "a name", [&target](const std::string& word) {
    target = word;
    return !word.empty();
  });
}

}  // namespace toolpace::cli
