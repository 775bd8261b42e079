/// Uses the installed library: fails unless headers, library and CMake package fit together.

#include <toolpace/base/numbers.h>

#include <cstdio>

int main() {
  const auto text = toolpace::to_text(0.1);
  std::puts(text.c_str());
  return text == "0.1" ? 0 : 1;
}
