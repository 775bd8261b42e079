#include "toolpace/base/file_identity.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "temporary_directory.h"
#include "toolpace/base/file_name.h"

namespace toolpace {
namespace {

using testing::TemporaryDirectory;

TEST(FileIdentity, IsTheSameThroughLinksOfBothKinds) {
  const TemporaryDirectory dir;
  std::ofstream(dir / "a") << "a";
  std::ofstream(dir / "b") << "a";
  std::filesystem::create_symlink("a", dir / "symbolic");
  std::filesystem::create_hard_link(dir / "a", dir / "hard");
  std::filesystem::create_directory_symlink(dir.path(), dir / "folder");
  const auto identity = identity_of(dir / "a");
  ASSERT_TRUE(identity);
  for (const char* name : {"symbolic", "hard", "folder/a", "./a"}) EXPECT_EQ(identity_of(dir / name), identity) << name;
  EXPECT_NE(identity_of(dir / "b"), identity);
}

TEST(FileIdentity, OfAFileThatIsNotThereYetIsItsPlace) {
  const TemporaryDirectory dir;
  std::filesystem::create_symlink("new", dir / "link");
  std::filesystem::create_directory_symlink(dir.path(), dir / "folder");
  const auto identity = identity_of(dir / "new");
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity_of(dir / "link"), identity);
  EXPECT_EQ(identity_of(dir / "folder" / "new"), identity);
  EXPECT_NE(identity_of(dir / "other"), identity);
}

TEST(FileIdentity, IsNoneForWhatMayBeReadAndWrittenAtOnce) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  for (const std::filesystem::path& file : {dir / "pipe", std::filesystem::path("/dev/null"), dir.path()}) {
    EXPECT_FALSE(identity_of(file)) << file;
  }
}

TEST(FileName, ExtensionsAreReadWithoutCase) {
  EXPECT_EQ(extension_of("Part.CSV"), ".csv");
  EXPECT_EQ(extension_of("part"), "");
  EXPECT_EQ(inner_extension_of("part.Pulses.csv"), ".pulses");
  EXPECT_EQ(inner_extension_of("part.csv"), "");
}

}  // namespace
}  // namespace toolpace
