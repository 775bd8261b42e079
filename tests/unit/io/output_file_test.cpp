#include "toolpace/io/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "temporary_directory.h"

namespace toolpace {
namespace {

using testing::contents;
using testing::TemporaryDirectory;

TEST(OutputFile, AppearsOnlyWhenCommitted) {
  const TemporaryDirectory dir;
  auto file = OutputFile::create(dir / "out.csv");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->write("hello"));
  EXPECT_FALSE(std::filesystem::exists(dir / "out.csv"));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(contents(dir / "out.csv"), "hello");
  EXPECT_EQ(dir.entries(), 1U);
}

TEST(OutputFile, LeavesTheOldFileAndNoLitterWhenAbandoned) {
  const TemporaryDirectory dir;
  ASSERT_TRUE(write_whole_file(dir / "out.csv", "old"));
  {
    auto file = OutputFile::create(dir / "out.csv");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write(std::string(1 << 20, 'x')));
  }
  EXPECT_EQ(contents(dir / "out.csv"), "old");
  EXPECT_EQ(dir.entries(), 1U);
}

TEST(OutputFile, KeepsTheModeOfTheFileItReplaces) {
  const TemporaryDirectory dir;
  ASSERT_TRUE(write_whole_file(dir / "out.csv", "old"));
  ASSERT_EQ(::chmod((dir / "out.csv").c_str(), 0640), 0);
  ASSERT_TRUE(write_whole_file(dir / "out.csv", "new"));
  struct stat info {};
  ASSERT_EQ(::stat((dir / "out.csv").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640U);
}

TEST(OutputFile, FollowsALinkInsteadOfReplacingIt) {
  const TemporaryDirectory dir;
  std::filesystem::create_symlink("real.csv", dir / "link.csv");  // points at nothing yet
  ASSERT_TRUE(write_whole_file(dir / "link.csv", "first"));
  ASSERT_TRUE(write_whole_file(dir / "link.csv", "second"));
  EXPECT_TRUE(std::filesystem::is_symlink(dir / "link.csv"));
  EXPECT_EQ(contents(dir / "real.csv"), "second");
}

TEST(OutputFile, NamesWhatIsWrongWithTheTarget) {
  const TemporaryDirectory dir;
  EXPECT_EQ(OutputFile::create(dir / "none" / "out.csv").error().code, "file-not-found");
  EXPECT_EQ(OutputFile::create(dir.path()).error().code, "is-directory");
  EXPECT_EQ(OutputFile::create(dir / "none" / "out.csv").error().kind, ErrorKind::io);
  if (::geteuid() == 0) return;  // root may write anywhere
  std::filesystem::permissions(dir.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_EQ(OutputFile::create(dir / "out.csv").error().code, "no-permission");
  std::filesystem::permissions(dir.path(), std::filesystem::perms::owner_all);
}

TEST(OutputFile, TakesLongNames) {
  const TemporaryDirectory dir;
  const auto target = dir / (std::string(250, 'n') + ".csv");
  ASSERT_TRUE(write_whole_file(target, "long"));
  EXPECT_EQ(contents(target), "long");
}

TEST(OutputFile, ReportsAFullDiskAndLeavesTheOldFile) {
  const TemporaryDirectory dir;
  ASSERT_TRUE(write_whole_file(dir / "out.csv", "old"));
  // A limit on the file size stands in for a full disk: the kernel refuses the write half way.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1 << 20, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto written = write_whole_file(dir / "out.csv", std::string(3 << 20, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, "file-too-large");
  EXPECT_EQ(contents(dir / "out.csv"), "old");
  EXPECT_EQ(dir.entries(), 1U);
}

TEST(OutputFile, WritesDevicesDirectly) {
  ASSERT_TRUE(write_whole_file("/dev/null", "gone"));
  const auto full = write_whole_file("/dev/full", "x");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().code, "disk-full");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(OutputFile, ReportsAClosedPipe) {
  const TemporaryDirectory dir;
  const auto handler = std::signal(SIGPIPE, SIG_IGN);
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  std::thread reader([&] { ::close(::open((dir / "pipe").c_str(), O_RDONLY)); });
  auto file = OutputFile::create(dir / "pipe");
  ASSERT_TRUE(file);
  reader.join();
  const auto written = file->write(std::string(1 << 20, 'x'));
  std::signal(SIGPIPE, handler);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, "closed-pipe");
}

TEST(OutputFile, OverwritesWhatWasWrittenEvenForAPipe) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = contents(dir / "pipe"); });
  {
    auto file = OutputFile::create(dir / "pipe", OutputFile::Access::patched);
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("....tail"));
    ASSERT_TRUE(file->overwrite(0, "head"));
    ASSERT_TRUE(file->commit());
  }
  reader.join();
  EXPECT_EQ(got, "headtail");
}

TEST(OutputFile, StopsWaitingForTheReaderOfAPipe) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  std::stop_source source;
  std::thread asker([&] { source.request_stop(); });
  const auto file = OutputFile::create(dir / "pipe", OutputFile::Access::forward, {source.get_token(), {}});
  asker.join();
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, ErrorKind::cancelled);
}

TEST(OutputFile, StopsWaitingForAReaderThatDoesNotRead) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  const int reader = ::open((dir / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  std::stop_source source;
  auto file = OutputFile::create(dir / "pipe", OutputFile::Access::forward, {source.get_token(), {}});
  ASSERT_TRUE(file);
  std::thread asker([&] { source.request_stop(); });
  const auto written = file->write(std::string(1 << 20, 'x'));  // a pipe holds 64 KiB
  asker.join();
  ::close(reader);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::cancelled);
}

TEST(OutputFile, WritesAnOpenDescriptorFromWhereItStands) {
  const TemporaryDirectory dir;
  const int descriptor = ::open((dir / "a").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(::write(descriptor, "head ", 5), 5);
  const std::string number = std::to_string(descriptor);
  std::filesystem::create_symlink("/dev/fd/" + number, dir / "link");
  for (const auto& name :
       {std::filesystem::path("/dev/fd/" + number), std::filesystem::path("/proc/self/fd/" + number), dir / "link"}) {
    const auto written = write_whole_file(name, "more ");
    EXPECT_TRUE(written) << name;
  }
  EXPECT_EQ(::fcntl(descriptor, F_GETFD) < 0, false) << "it is lent, not closed";
  ::close(descriptor);
  EXPECT_EQ(contents(dir / "a"), "head more more more ");
  EXPECT_EQ(dir.entries(), 2U);
}

TEST(OutputFile, SweepsTheTemporariesOfTheDeadAndNoOthers) {
  const TemporaryDirectory dir;
  auto living = OutputFile::create(dir / "living.csv");
  ASSERT_TRUE(living && living->write("alive"));
  // What a killed process leaves: nobody holds it, and its number may be anyone's by now.
  const std::string mine = std::to_string(::getpid());
  for (const auto& name : {".out.csv.toolpace-1-0.tmp", ".other.toolpace-99999-12.tmp"})
    std::ofstream(dir / name) << "half";
  std::ofstream(dir / (".out.csv.toolpace-" + mine + "-0.tmp")) << "half";
  for (const auto& name : {"out.csv.toolpace-1-0.tmp", ".out.csv.tmp", ".toolpace-x-1.tmp", ".a.toolpace-1.tmp"}) {
    std::ofstream(dir / name) << "of someone else";
  }
  ASSERT_TRUE(write_whole_file(dir / "out.csv", "new"));
  ASSERT_TRUE(living->commit());
  EXPECT_EQ(contents(dir / "living.csv"), "alive");
  EXPECT_EQ(contents(dir / "out.csv"), "new");
  EXPECT_EQ(dir.entries(), 2U + 4U);
}

TEST(OutputFile, DoesNotFollowLinksInACircle) {
  const TemporaryDirectory dir;
  std::filesystem::create_symlink("b", dir / "a");
  std::filesystem::create_symlink("a", dir / "b");
  EXPECT_FALSE(OutputFile::create(dir / "a"));
  EXPECT_EQ(dir.entries(), 2U);
}

}  // namespace
}  // namespace toolpace
