#include "toolpace/io/pulse_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace toolpace {
namespace {

namespace fs = std::filesystem;

class PulseWriter : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("toolpace-pulses-" + std::to_string(::getpid()));
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const char* name) const { return folder_ / name; }
  static std::string text(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream out;
    out << in.rdbuf();
    return out.str();
  }
  static PulseTable table(std::uint64_t steps) { return PulseTable::create({steps, 5000, 0.05, 0.03, 1e6}).value(); }

  fs::path folder_;
};

TEST_F(PulseWriter, CsvHoldsEveryPulseAcrossChunks) {
  const PulseTable pulses = table(20'000);
  ASSERT_TRUE(write_pulses(file("p.csv"), pulses, PulseFormat::csv));
  std::istringstream in(text(file("p.csv")));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "pulse,ticks");
  std::uint64_t pulse = 0, sum = 0, number = 0, ticks = 0;
  char comma = 0;
  while (in >> number >> comma >> ticks) {
    EXPECT_EQ(number, ++pulse);
    sum += ticks;
  }
  EXPECT_EQ(pulse, 20'000u);
  EXPECT_EQ(sum, pulses.total_ticks());
}

TEST_F(PulseWriter, TheHeaderIsWhatACCompilerTakes) {
  ASSERT_TRUE(write_pulses(file("p.h"), table(9000), PulseFormat::c_header));
  std::ofstream(file("main.c")) << "#include \"p.h\"\n#include \"p.h\"\n"
                                   "int main(void) {\n  unsigned long long sum = 0;\n"
                                   "  for (unsigned long i = 0; i < PULSE_COUNT; ++i) sum += pulse_ticks[i];\n"
                                   "  return sum == "
                                << table(9000).total_ticks() << "ULL && sizeof pulse_ticks == 9000 * 4 ? 0 : 1;\n}\n";
  const std::string program = file("p").string();
  const std::string compile = "cc -std=c99 -Wall -Wextra -Werror -o " + program + " " + file("main.c").string();
  if (std::system("cc --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no C compiler called cc";
  ASSERT_EQ(std::system(compile.c_str()), 0);
  EXPECT_EQ(std::system(program.c_str()), 0);
}

TEST_F(PulseWriter, TheHeaderSaysWithWhichParametersItWasMade) {
  ASSERT_TRUE(write_pulses(file("p.h"), table(9), PulseFormat::c_header));
  const std::string head = text(file("p.h"));
  for (const char* part :
       {"steps 9", "top speed 5000 step/s", "acceleration 50 ms", "deceleration 30 ms", "timer 1e+06 Hz"}) {
    EXPECT_NE(head.find(part), std::string::npos) << part << " in " << head;
  }
}

TEST_F(PulseWriter, ACancelledExportLeavesTheOldFile) {
  std::ofstream(file("p.csv")) << "old";
  std::stop_source stop;
  stop.request_stop();
  const auto written = write_pulses(file("p.csv"), table(100), PulseFormat::csv, {stop.get_token(), {}});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::cancelled);
  EXPECT_EQ(text(file("p.csv")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(PulseWriter, AMissingFolderIsAFileError) {
  const auto written = write_pulses(file("nowhere/p.csv"), table(3), PulseFormat::csv);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::io);
}

}  // namespace
}  // namespace toolpace
