#include "toolpace/io/output_guard.h"

#include <gtest/gtest.h>

#include <fstream>

#include "temporary_directory.h"

namespace toolpace {
namespace {

using testing::TemporaryDirectory;

TEST(OutputGuard, RefusesAnOutputThatIsAnInputByAnyName) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.ngc") << "G0";
  std::filesystem::create_hard_link(dir / "a.ngc", dir / "hard");
  std::filesystem::create_symlink("hard", dir / "link");
  for (const char* name : {"a.ngc", "hard", "link"}) {
    const auto apart = check_outputs({{"--setpoints", dir / name}}, {{"the program", dir / "a.ngc"}});
    ASSERT_FALSE(apart) << name;
    EXPECT_EQ(apart.error().code, "output-is-input");
    EXPECT_EQ(apart.error().kind, ErrorKind::usage);
    EXPECT_EQ(apart.error().where.file, (dir / name).string());
    EXPECT_NE(apart.error().message.find("the program"), std::string::npos);
  }
}

TEST(OutputGuard, RefusesTwoOutputsThatAreOneFileEvenBeforeItIsThere) {
  const TemporaryDirectory dir;
  std::filesystem::create_symlink("new", dir / "link");
  EXPECT_EQ(check_outputs({{"one", dir / "new"}, {"two", dir / "link"}}, {}).error().code, "output-twice");
  EXPECT_TRUE(check_outputs({{"one", dir / "new"}, {"two", dir / "other"}}, {}));
}

TEST(OutputGuard, LetsThroughWhatLosesNothing) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a.ngc") << "G0";
  EXPECT_TRUE(check_outputs({{"--setpoints", dir / "a.csv"}, {"--trace", {}}},
                            {{"the program", dir / "a.ngc"}, {"tools", {}}}));
  EXPECT_TRUE(check_outputs({{"--setpoints", "/dev/null"}}, {{"the program", "/dev/null"}}));
}

}  // namespace
}  // namespace toolpace
