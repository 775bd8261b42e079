#include "console.h"

#include "commands.h"
#include "toolpace/base/exception_error.h"

namespace toolpace::cli {
namespace {

thread_local Console* current = nullptr;

/// A console in the place of the terminal, or of another console, as long as it lives.
class InPlace {
 public:
  explicit InPlace(Console& console) : before_(current) { current = &console; }
  ~InPlace() { current = before_; }
  InPlace(const InPlace&) = delete;
  InPlace& operator=(const InPlace&) = delete;

 private:
  Console* before_;
};

}  // namespace

Console* console() { return current; }

Done run_words(const std::vector<std::string>& words, Console& console) {
  const InPlace in_place(console);
  try {
    std::vector<const char*> argv = {"toolpace"};
    for (const std::string& word : words) argv.push_back(word.c_str());
    CommandLine line;
    add_commands(line);
    const auto action = line.parse(static_cast<int>(argv.size()), argv.data());
    return action ? (*action)() : tl::unexpected<Failure>(action.error());
  } catch (...) {
    return tl::unexpected<Failure>(caught_error());
  }
}

}  // namespace toolpace::cli
