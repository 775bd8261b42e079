#pragma once
/// Programs written again, as tests ask for it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>

#include "toolpace/nc/reader.h"
#include "toolpace/rewrite/rewrite.h"

namespace toolpace::test {

inline Rewritten written_again(const std::string& text, const RewriteOptions& options = {},
                               Dialect dialect = Dialect::linuxcnc) {
  ReadOptions read;
  read.dialect = dialect;
  const auto reading = read_text(text, "a.ngc", read);
  EXPECT_TRUE(reading && !reading->refused) << text;
  auto rewritten = rewrite(text, "a.ngc", *reading, read, options);
  EXPECT_TRUE(rewritten) << text;
  return std::move(rewritten.value());
}

/// "X… Y…" lines on a circle about 0, 0, from one angle to another [rad] in equal steps, the first left out.
inline std::string chords(double radius, double from, double to, int count, const char* format = "X{:.4f} Y{:.4f}\n") {
  std::string text;
  for (int k = 1; k <= count; ++k) {
    const double angle = from + (to - from) * k / count;
    text += fmt::format(fmt::runtime(format), radius * std::cos(angle), radius * std::sin(angle));
  }
  return text;
}

}  // namespace toolpace::test
