#include "toolpace/base/input_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <thread>

#include "temporary_directory.h"

namespace toolpace {
namespace {

using testing::TemporaryDirectory;

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TEST(InputFile, GivesAnyPieceOfAFile) {
  const TemporaryDirectory dir;
  write(dir / "a", "0123456789");
  const auto file = InputFile::open(dir / "a");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size(), 10U);
  std::array<char, 4> piece{};
  ASSERT_TRUE(file->read(6, piece.data(), piece.size()));
  EXPECT_EQ(std::string(piece.data(), 4), "6789");
  ASSERT_TRUE(file->read(0, piece.data(), 2));
  EXPECT_EQ(std::string(piece.data(), 2), "01");
  EXPECT_TRUE(file->check_unchanged());
}

TEST(InputFile, SaysThatAFileBecameShorterWhileItWasRead) {
  const TemporaryDirectory dir;
  write(dir / "a", std::string(1 << 16, 'x'));
  const auto file = InputFile::open(dir / "a");
  ASSERT_EQ(::truncate((dir / "a").c_str(), 100), 0);
  std::array<char, 50> piece{};
  EXPECT_TRUE(file->read(0, piece.data(), piece.size()));
  const auto behind = file->read(1000, piece.data(), piece.size());
  ASSERT_FALSE(behind);
  EXPECT_EQ(behind.error().code, "file-changed");
  EXPECT_EQ(behind.error().kind, ErrorKind::io);
  EXPECT_EQ(file->check_unchanged().error().code, "file-changed");
}

TEST(InputFile, SaysThatAFileGrewOrWasWrittenOver) {
  const TemporaryDirectory dir;
  write(dir / "a", "abc");
  const auto file = InputFile::open(dir / "a");
  ASSERT_TRUE(file->check_unchanged());
  std::ofstream(dir / "a", std::ios::app) << "d";
  EXPECT_EQ(file->check_unchanged().error().code, "file-changed");
  write(dir / "b", "abc");
  const auto other = InputFile::open(dir / "b");
  const std::array<timespec, 2> later = {timespec{0, UTIME_OMIT}, timespec{4'000'000'000, 5}};
  ASSERT_EQ(::utimensat(AT_FDCWD, (dir / "b").c_str(), later.data(), 0), 0);
  EXPECT_EQ(other->check_unchanged().error().code, "file-changed");
}

TEST(InputFile, TakesAPipeWhole) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  const std::string text(300'000, 'p');
  std::thread writer([&] { write(dir / "pipe", text); });
  const auto content = read_whole_file(dir / "pipe");
  writer.join();
  ASSERT_TRUE(content);
  EXPECT_EQ(content->bytes(), text);
}

TEST(InputFile, StopsWaitingForTheWriterOfAPipe) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  std::stop_source source;
  std::thread asker([&] { source.request_stop(); });
  const auto content = read_whole_file(dir / "pipe", {source.get_token(), {}});
  asker.join();
  ASSERT_FALSE(content);
  EXPECT_EQ(content.error().kind, ErrorKind::cancelled);
}

TEST(InputFile, ReadsADescriptorFromWhereItStands) {
  const TemporaryDirectory dir;
  write(dir / "a", "head\nbody\n");
  const int descriptor = ::open((dir / "a").c_str(), O_RDONLY);
  ASSERT_EQ(::lseek(descriptor, 5, SEEK_SET), 5);
  const auto content = read_whole_file("/dev/fd/" + std::to_string(descriptor));
  ::close(descriptor);
  ASSERT_TRUE(content);
  EXPECT_EQ(content->bytes(), "body\n");
}

TEST(InputFile, ReadsFilesOfTheSystemThatSayTheyAreEmpty) {
  const auto content = read_whole_file("/proc/self/status");
  ASSERT_TRUE(content);
  EXPECT_NE(content->bytes().find("Name:"), std::string_view::npos);
}

TEST(InputFile, NamesWhatIsWrong) {
  const TemporaryDirectory dir;
  EXPECT_EQ(read_whole_file(dir / "none").error().code, "file-not-found");
  EXPECT_EQ(read_whole_file(dir.path()).error().code, "is-directory");
  write(dir / "empty", "");
  EXPECT_EQ(read_whole_file(dir / "empty")->bytes(), "");
}

}  // namespace
}  // namespace toolpace
