/// Machine files edited in place: without a change they keep every byte; with one they hold it, and every comment.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "../support/random_setup.h"
#include "toolpace/machine/key_text.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/toml_layout.h"

namespace {

using namespace toolpace;

std::vector<std::string> comments_of(std::string_view text) {
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  std::vector<std::string> comments;
  const auto layout = lay_out_toml(text);
  if (!layout) std::abort();
  for (const TextSpan& c : layout->comments) comments.emplace_back(text.substr(c.begin, c.end - c.begin));
  return comments;
}

void require(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
  std::abort();
}

}  // namespace

/// The first byte is the seed of the change.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  (void)lay_out_toml(text);
  auto setup = parse_setup(text, "fuzz.toml", UnknownKeys::pass_over);
  if (!setup) return 0;
  require(edit_setup(text, "fuzz.toml", *setup).value_or("refused") == text, "a byte changed", text);
  test::RandomSetup(data[0]).change(*setup, 6);
  const auto edited = edit_setup(text, "fuzz.toml", *setup);
  require(edited.has_value(), edited ? "" : edited.error().message.c_str(), text);
  const auto again = parse_setup(*edited, "again.toml", UnknownKeys::pass_over);
  require(again && is_same_file(*again, *setup), "another machine", *edited);
  require(comments_of(*edited) == comments_of(text), "other comments", *edited);
  return 0;
}
