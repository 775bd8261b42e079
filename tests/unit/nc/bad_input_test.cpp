/// What is wrong is said where it is, quickly, and what can be read is read.

#include <filesystem>
#include <fstream>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

TEST(BadInput, AMissingFileAndADirectoryAreFileTrouble) {
  const auto missing = read_file("/nowhere/at/all.ngc");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::io);
  EXPECT_EQ(missing.error().code, "file-not-found");
  const auto folder = read_file(std::filesystem::temp_directory_path());
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, "is-directory");
}

TEST(BadInput, EmptyAndBinaryTextsAreRefused) {
  const auto empty = read_text(" \r\n\t\n", "a.ngc");
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, "empty-program");
  const auto binary = read_text(std::string("G1\0X", 4), "a.ngc");
  ASSERT_FALSE(binary);
  EXPECT_EQ(binary.error().code, "not-text");
}

TEST(BadInput, EveryFaultOfAProgramIsToldWithLineAndColumn) {
  const auto reading = read_program("G21 F100\nG1 X1\nG1 Xnan\n  G1 X[1/0]\nG99.9 X5\nG1 X1 X2\nG1 X7\nM2\n");
  EXPECT_TRUE(reading.refused);
  EXPECT_EQ(codes(reading),
            (Codes{"number-expected@3:4", "division-by-zero@4:10", "g-code-unknown@5:1", "word-twice@6:7"}));
  EXPECT_EQ(reading.diagnostics[1].excerpt, "G1 X[1/0]");
  EXPECT_EQ(ends(reading), (Values{1.0})) << "motion ends before the first error";
}

TEST(BadInput, NumbersThatNoDoubleHoldsAreRefused) {
  EXPECT_EQ(codes(read_program("G1 X" + std::string(400, '9') + " F5\nM2\n")), (Codes{"number-too-large@1:5"}));
  EXPECT_EQ(codes(read_program("G1 X[10**400] F5\nM2\n")).front().substr(0, 16), "number-too-large");
  EXPECT_EQ(codes(read_program("G1 X1e400 F5\nM2\n")), (Codes{"word-unused@1:6"}));
}

TEST(BadInput, PlacesThatNoMachineReachesAreRefused) {
  const std::string far = "1" + std::string(200, '0');
  const auto code = [](const std::string& text) {
    return read_program("G21 F100\n" + text + "\nM2\n").diagnostics.at(0).code;
  };
  EXPECT_EQ(code("G0 X" + far), "coordinate-too-large");
  EXPECT_EQ(code("G10 L2 P1 X" + far + "\nG54\nG0 X0"), "coordinate-too-large");
  EXPECT_EQ(code("G2 X1 Y0 I" + far), "arc-radius-too-large");
  EXPECT_EQ(code("G2 X1 Y0 R" + far), "arc-radius-too-large");
  EXPECT_EQ(code("G5 X1 Y1 I" + far + " J0 P0 Q0"), "coordinate-too-large");
  EXPECT_EQ(code("G1 X1 F" + far), "feed-too-large");
}

TEST(BadInput, ALineOfTenMegabytesIsOneError) {
  const auto reading = read_program("G1 F5 X" + std::string(10'000'000, '1') + "\nG0 X1\nM2\n");
  EXPECT_EQ(codes(reading), (Codes{"line-too-long@1:1"}));
  EXPECT_LE(reading.diagnostics[0].excerpt.size(), 80u);
}

TEST(BadInput, AFeedMoveWithoutFeedNamesTheRemedy) {
  const auto reading = read_program("G21\nG1 X5\nM2\n");
  EXPECT_EQ(codes(reading), (Codes{"no-feed@2:1"}));
  EXPECT_FALSE(reading.diagnostics[0].remedy.empty());
}

TEST(BadInput, ARadiusTooSmallTellsTheLeastOne) {
  const auto reading = read_program("G21 F100\nG2 X20 R9.9\nM2\n");
  EXPECT_EQ(codes(reading), (Codes{"arc-radius-too-small@2:8"}));
  EXPECT_EQ(reading.diagnostics[0].remedy, "the radius must be at least 10.0000 mm");
}

TEST(BadInput, ErrorsWithoutEndAreCountedNotListed) {
  std::string text = "G21\n";
  for (int i = 0; i < 5000; ++i) text += "G1 X5\n";
  const auto reading = read_program(text + "M2\n");
  EXPECT_TRUE(reading.refused);
  EXPECT_LT(reading.diagnostics.size(), 150u);
  EXPECT_EQ(reading.diagnostics.back().severity, Severity::note);
}

TEST(BadInput, StrictReadingMakesWarningsErrors) {
  const std::string text = "G21 F100\nM150\nG1 X1\nM2\n";
  EXPECT_FALSE(read_program(text).refused);
  EXPECT_TRUE(read_program(text, {.strict = true}).refused);
}

TEST(BadInput, ANulByteFarIntoAProgramIsNoEndOfItsLine) {
  std::string text = "G21 F100\n";
  while (text.size() < 100'000) text += "G1 X1 Y1\n";
  EXPECT_EQ(codes(read_program(text + std::string("G1 X5 \0 Y5\nM2\n", 14))).at(0).substr(0, 13), "bad-character");
  EXPECT_EQ(codes(read_program(text + std::string("\0\nM2\n", 5))).at(0).substr(0, 13), "bad-character");
}

TEST(BadInput, NumbersThatCountAreWholeAndHeldByAnInteger) {
  const auto code = [](const std::string& text) { return codes(read_program(text + "\nM2\n")).at(0); };
  EXPECT_EQ(code("G10 L3111111111 P1 X0"), "g10-form@1:1");
  EXPECT_EQ(code("G18 G41.1 D1 L3000000000"), "compensation-orientation@1:14");
  EXPECT_EQ(code("G41 D3000000000"), "tool-number@1:5");
  EXPECT_EQ(code("F1 G91 G81 X1 Z-1 R1 L3000000000"), "cycle-repeats@1:8");
  EXPECT_EQ(code("G10 L1 P1 Q3000000000"), "tool-orientation@1:11");
}

TEST(BadInput, AMissingEndIsToldAtTheEnd) {
  EXPECT_EQ(codes(read_program("o1 sub\nG0 X1\no1 endsub\n")), (Codes{"program-without-end@3:1"}));
  EXPECT_EQ(codes(read_program("G21\nG0 X1\n")), (Codes{"program-without-end@2:1"}));
}

TEST(BadInput, TheExcerptOfAFaultInABranchIsTheBranch) {
  const auto reading = read_program("#1=0\no1 if [#1]\no1 elseif [1/#1]\no1 endif\nM2\n");
  EXPECT_EQ(codes(reading), (Codes{"division-by-zero@3:14"}));
  EXPECT_EQ(reading.diagnostics.at(0).excerpt, "o1 elseif [1/#1]");
}

TEST(BadInput, SubProgramsAreReadFromTheGivenFoldersOnly) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "toolpace_sub_test";
  fs::remove_all(folder);
  fs::create_directories(folder / "program");
  fs::create_directories(folder / "library");
  const std::string inner = "o<inner> sub\nG0 X#1\no<inner> endsub\nM2\n";
  std::ofstream(folder / "secret.ngc") << "o<secret> sub\nG0 X99\no<secret> endsub\nM2\n";
  std::ofstream(folder / "library" / "inner.ngc") << inner;
  fs::create_symlink(folder / "secret.ngc", folder / "program" / "linked.ngc");
  const auto program = [&](const std::string& name) {
    std::ofstream(folder / "program" / "main.ngc") << "o<" + name + "> call [5]\nM2\n";
    return folder / "program" / "main.ngc";
  };

  const auto without = read_file(program("inner"));
  ASSERT_TRUE(without);
  EXPECT_EQ(without->diagnostics.at(0).code, "sub-program-unknown");
  const auto with = read_file(program("inner"), {.sub_paths = {folder / "library"}});
  ASSERT_TRUE(with);
  EXPECT_EQ(ends(*with), (Values{5.0}));
  EXPECT_EQ(with->moves.files.size(), 2u);
  EXPECT_EQ(with->moves.file[0], 1u);
  EXPECT_EQ(read_file(program("linked"))->diagnostics.at(0).code,
            "sub-program-refused");  // it is there, and leads outside
  for (const char* name : {"../secret", "/etc/passwd", "..", "secret"}) {
    const auto reading = read_file(program(name));
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->diagnostics.at(0).code, "sub-program-unknown") << name;
  }
  fs::remove_all(folder);
}

TEST(BadInput, CancellingEndsReadingWhereItIs) {
  std::string text;
  for (int i = 0; i < 200000; ++i) text += "G0 X1\n";
  for (const double moment : {0.0, 0.3, 0.8}) {
    std::stop_source stop;
    int later = 0;
    const auto reading = read_text(text + "M2\n", "a.ngc", {}, {stop.get_token(), [&](double fraction) {
                                                                  if (stop.stop_requested()) ++later;
                                                                  if (fraction >= moment) stop.request_stop();
                                                                }});
    ASSERT_FALSE(reading) << moment;
    EXPECT_EQ(reading.error().kind, ErrorKind::cancelled);
    EXPECT_LE(later, 1) << moment;
  }
}

}  // namespace
}  // namespace toolpace::nc
