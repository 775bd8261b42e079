#include "toolpace/base/error_text.h"

#include <gtest/gtest.h>

namespace toolpace {
namespace {

TEST(ErrorText, NamesAsMuchOfThePlaceAsIsKnown) {
  Error error{ErrorKind::input, "bad", "it is bad", {}, {}, {}};
  EXPECT_EQ(error_text(error), "error: it is bad [bad]\n");
  error.where.file = "a.ngc";
  EXPECT_EQ(error_text(error), "a.ngc: error: it is bad [bad]\n");
  error.where.line = 3;
  EXPECT_EQ(error_text(error), "a.ngc:3: error: it is bad [bad]\n");
  error.where.column = 7;
  EXPECT_EQ(error_text(error), "a.ngc:3:7: error: it is bad [bad]\n");
}

TEST(ErrorText, PutsExcerptAndRemedyBelow) {
  const Diagnostic d{Severity::warning, "odd", "it is odd", "mend it", {"a.ngc", 2, 0}, "G1 X"};
  EXPECT_EQ(diagnostic_text(d), "a.ngc:2: warning: it is odd [odd]\n  G1 X\n  mend it\n");
}

}  // namespace
}  // namespace toolpace
