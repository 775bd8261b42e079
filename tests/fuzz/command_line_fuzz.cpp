/// Command lines of any words, which newlines or NULs part: read into a command that could run, or refused in words. Nothing runs.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "commands.h"

namespace {

using namespace toolpace::cli;

constexpr std::size_t kMostWords = 64;

std::vector<std::string> words_of(const std::uint8_t* data, std::size_t size) {
  const auto is_end = [](std::uint8_t byte) { return byte == '\n' || byte == '\0'; };
  std::vector<std::string> words = {"toolpace"};
  const std::uint8_t* const end = data + size;
  while (data != end && words.size() < kMostWords) {
    const std::uint8_t* const stop = std::find_if(data, end, is_end);
    words.emplace_back(data, stop);
    data = stop == end ? end : stop + 1;
  }
  return words;
}

}  // namespace

/// --help would print a million times.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::cout.rdbuf(nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto words = words_of(data, size);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  CommandLine line;
  add_commands(line);
  const auto action = line.parse(static_cast<int>(pointers.size()), pointers.data());
  const bool is_answered =
      action ? *action != nullptr : !action.error().message.empty() && !action.error().code.empty();
  if (!is_answered) std::abort();
  return 0;
}
