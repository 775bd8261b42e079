/// The binary formats, read by the tool people have: numpy of the system's Python.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <thread>

#include "sample_setpoints.h"
#include "temporary_directory.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/io/setpoint_writer.h"

namespace toolpace {
namespace {

using testing::contents;
using testing::sample_setpoints;
using testing::TemporaryDirectory;

constexpr const char* kPython = "/usr/bin/python3";

bool has_numpy() { return std::system((std::string(kPython) + " -c 'import numpy' 2>/dev/null").c_str()) == 0; }

/// Runs a script with numpy as np; `d` is the directory. The script asserts.
int run_numpy(const TemporaryDirectory& dir, const std::string& script) {
  std::ofstream(dir / "check.py") << "import json\nimport numpy as np\nd = '" << dir.path().string() << "/'\n"
                                  << script;
  return std::system((std::string(kPython) + " " + (dir / "check.py").string()).c_str());
}

void write_all(const std::filesystem::path& file, bool rotary, SetpointFileOptions options = {}) {
  auto writer = open_setpoint_writer(file, options);
  ASSERT_TRUE(writer) << writer.error().message;
  for (std::size_t first = 0; first < 10000; first += 2500) {
    ASSERT_TRUE((*writer)->write(sample_setpoints(first, 2500, rotary)));
  }
  ASSERT_TRUE((*writer)->finish());
}

TEST(Numpy, NpyHoldsTheColumnsOfTheCsv) {
  if (!has_numpy()) GTEST_SKIP() << "needs python3-numpy";
  const TemporaryDirectory dir;
  write_all(dir / "a.npy", false);
  write_all(dir / "a.csv", false);
  EXPECT_EQ(run_numpy(dir,
                      "a = np.load(d + 'a.npy')\n"
                      "c = np.loadtxt(d + 'a.csv', delimiter=',', skiprows=1)\n"
                      "assert a.shape == (10000, 7) and a.dtype == np.float64 and a.flags['C_CONTIGUOUS']\n"
                      "assert (a == c[:, :7]).all()\n"),
            0);
}

TEST(Numpy, NpzHoldsSetpointsLinesAndMeta) {
  if (!has_numpy()) GTEST_SKIP() << "needs python3-numpy";
  const TemporaryDirectory dir;
  write_all(dir / "a.npy", true, {.axis_derivatives = true});
  write_all(dir / "a.npz", true, {.axis_derivatives = true, .program_name = "Fräsen \"零件\".ngc"});
  EXPECT_EQ(run_numpy(dir,
                      "z = np.load(d + 'a.npz')\n"
                      "assert (z['setpoints'] == np.load(d + 'a.npy')).all()\n"
                      "assert z['line'].dtype == np.int64 and (z['line'] == np.arange(10000) // 7 + 1).all()\n"
                      "m = json.loads(str(z['meta']))\n"
                      "assert m['program'] == 'Fräsen \"零件\".ngc' and m['period_s'] == 0.001\n"
                      "assert m['columns'][4:7] == ['a_deg', 'b_deg', 'c_deg']\n"
                      "assert len(m['columns']) == z['setpoints'].shape[1] == 10 + 18\n"
                      "import zipfile; assert zipfile.ZipFile(d + 'a.npz').testzip() is None\n"),
            0);
}

TEST(Numpy, NpyThroughAPipeIsTheSameFile) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe.npy").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = contents(dir / "pipe.npy"); });
  write_all(dir / "pipe.npy", false);
  reader.join();
  write_all(dir / "file.npy", false);
  EXPECT_EQ(got, contents(dir / "file.npy"));
}

TEST(Numpy, AnEmptyProgramIsStillAnArray) {
  if (!has_numpy()) GTEST_SKIP() << "needs python3-numpy";
  const TemporaryDirectory dir;
  for (const char* name : {"a.npy", "a.npz"}) {
    auto writer = open_setpoint_writer(dir / name);
    ASSERT_TRUE((*writer)->finish());
  }
  EXPECT_EQ(run_numpy(dir,
                      "assert np.load(d + 'a.npy').shape == (0, 0)\n"
                      "assert np.load(d + 'a.npz')['line'].shape == (0,)\n"),
            0);
}

TEST(Numpy, ArchivesThatNumpyCompressedAreReadBack) {
  if (!has_numpy()) GTEST_SKIP() << "needs python3-numpy";
  const TemporaryDirectory dir;
  write_all(dir / "a.npz", false);
  ASSERT_EQ(
      run_numpy(
          dir,
          "z = np.load(d + 'a.npz'); np.savez_compressed(d + 'b.npz', setpoints=z['setpoints'], line=z['line'])\n"),
      0);
  for (const char* name : {"a.npz", "b.npz"}) {
    auto file = open_setpoint_file(dir / name);
    ASSERT_TRUE(file) << file.error().message;
    for (int pass = 0; pass < 2; ++pass, (*file)->rewind()) {
      SetpointRows rows;
      ASSERT_EQ((*file)->read(rows, 20000), 10000U) << name;
      EXPECT_EQ(rows.position[0], sample_setpoints(0, 10000, false).position[0]);
      EXPECT_EQ(rows.line.back(), 9999U / 7 + 1);
    }
  }
}

TEST(Numpy, AnArchiveIsTheSameFileEveryTimeAndThroughAPipe) {
  const TemporaryDirectory dir;
  ASSERT_EQ(::mkfifo((dir / "pipe.npz").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = contents(dir / "pipe.npz"); });
  write_all(dir / "pipe.npz", true);
  reader.join();
  write_all(dir / "file.npz", true);
  write_all(dir / "again.npz", true);
  EXPECT_EQ(contents(dir / "file.npz"), contents(dir / "again.npz"));
  EXPECT_EQ(contents(dir / "file.npz"), got);
}

}  // namespace
}  // namespace toolpace
