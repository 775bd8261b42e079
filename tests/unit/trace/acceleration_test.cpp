/// Recordings of accelerometers, in the layouts that there are.

#include "toolpace/trace/acceleration.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "toolpace/servo/find_modes.h"

namespace toolpace {
namespace {

constexpr std::size_t kRows = 600;

class Recording : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const auto file = std::filesystem::path(testing::TempDir()) / "recording.csv";
    std::ofstream(file) << text;
    return file;
  }
  /// Rows every 0.5 ms, made by a format of time and value.
  static std::string rows(const char* format, double jitter = 0) {
    std::string text;
    for (std::size_t i = 0; i < kRows; ++i) {
      const double t = 7 + 5e-4 * (static_cast<double>(i) + (i % 2 == 1 ? jitter : 0.0));
      text += fmt::format(fmt::runtime(format), t, std::sin(static_cast<double>(i)));
    }
    return text;
  }
};

TEST_F(Recording, OfKlipperIsInMillimetresPerSecondSquared) {
  const auto r = read_acceleration(write("#time,accel_x,accel_y,accel_z\n" + rows("{:.6f},{:.6f},1,9806\n")), {});
  ASSERT_TRUE(r) << r.error().message;
  EXPECT_NEAR(r->period, 5e-4, 1e-9);
  ASSERT_EQ(r->rows(), kRows);
  EXPECT_NEAR(r->axis[0][2], std::sin(2.0), 1e-6);
  EXPECT_EQ(r->axis[2][0], 9806);
}

TEST_F(Recording, MayBeInOtherUnitsAndNames) {
  const auto g = read_acceleration(write("t [s];Acc Z [g];Acc X [mg]\n" + rows("{0:.6f};{1:.6f};{1:.6f}\n")), {});
  ASSERT_TRUE(g) << g.error().message;
  EXPECT_TRUE(g->axis[1].empty());
  EXPECT_NEAR(g->axis[2][1], 9806.65 * std::sin(1.0), 0.01);
  EXPECT_NEAR(g->axis[0][1], 9.80665 * std::sin(1.0), 1e-5);
  const auto told = read_acceleration(write("when,up,across\n" + rows("{:.6f},1,{:.6f}\n")), {"t=1,y=3[m/s2]", {}});
  ASSERT_TRUE(told) << told.error().message;
  EXPECT_NEAR(told->axis[1][1], 1000 * std::sin(1.0), 1e-3);
  const auto plain = read_acceleration(write(rows("{:.6f} {:.6f} 2 3\n")), {});
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->axis[1][0], 2);
}

TEST_F(Recording, AtStepsThatScatterIsMadeEven) {
  const auto r = read_acceleration(write("#time,accel_x,accel_y,accel_z\n" + rows("{:.6f},{:.6f},1,1\n", 0.2)), {});
  ASSERT_TRUE(r) << r.error().message;
  EXPECT_EQ(r->rows(), kRows);
  EXPECT_EQ(read_acceleration(write("t,accel_x\n" + rows("{:.6f},{:.6f}\n", 0.6)), {}).error().code,
            "accelerometer-uneven");
}

TEST_F(Recording, SaysWhatIsWrongWithIt) {
  const auto code = [&](const std::string& text, const AccelerationOptions& options = {}) {
    const auto r = read_acceleration(write(text), options);
    return r ? std::string("fine") : r.error().code;
  };
  EXPECT_EQ(code("t,accel_x\n" + rows("{:.6f},{:.6f}\n").substr(0, 900)), "accelerometer-short");
  EXPECT_EQ(code("t,temperature\n" + rows("{:.6f},{:.6f}\n")), "accelerometer-columns");
  EXPECT_EQ(code("t,q\n" + rows("{:.6f},{:.6f}\n"), {"t=1,x=2[lb]", {}}), "accelerometer-columns");
  EXPECT_EQ(code("t,accel_x\n" + rows("{:.6f},{:.6f}\n") + "9,1\n"), "trace-gap");
  EXPECT_EQ(code(""), "trace-empty");
}

}  // namespace
}  // namespace toolpace
