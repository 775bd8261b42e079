#include "toolpace/controller/prediction.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

#include "sample_settings.h"
#include "toolpace/nc/reader.h"

namespace toolpace {
namespace {

using namespace testing;

Prediction predict_with(const char* settings, const std::string& program, Controller controller,
                        const PredictOptions& options = {}) {
  const auto parsed = parse_controller_settings(settings, "settings", controller);
  EXPECT_TRUE(parsed) << parsed.error().message;
  ReadOptions reading;
  reading.dialect = dialect_of(controller);
  const auto read = read_text(program, "p.nc", reading);
  EXPECT_TRUE(read);
  auto prediction = predict(*read, scan_program(program), *parsed, options);
  EXPECT_TRUE(prediction) << prediction.error().message;
  return *prediction;
}

double sum(const Prediction& p) { return std::accumulate(p.time_by_limit.begin(), p.time_by_limit.end(), 0.0); }
double spent(const Prediction& p, TimeLimit limit) { return p.time_by_limit[static_cast<std::size_t>(limit)]; }

/// Lines of random lengths and directions, feeds that change, now and then an arc or a dwell.
std::string random_program(unsigned seed, std::size_t lines, bool for_printer) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-3, 3), feed(300, 5000);
  std::string text = "G21 G90\nG1 F1200\n";
  double x = 0, y = 0;
  for (std::size_t i = 0; i < lines; ++i) {
    x += step(random);
    y += step(random);
    text += "G1 X" + std::to_string(x) + " Y" + std::to_string(y) + " Z" + std::to_string(0.05 * step(random)) + " F" +
            std::to_string(feed(random)) + "\n";
    if (i % 40 == 39) text += for_printer ? "G4 P100\n" : "G4 P0.1\n";
  }
  return text + "M2\n";
}

// 100 mm at 60 mm/s with 500 mm/s²: 100/60 + 60/500 = 1.78667 s; the steps' timer adds a little, the last step is early.
TEST(Predict, ALoneLineOfGrblIsATrapezoid) {
  const auto p = predict_with(kGrbl, "G21 G90\nG1 X100 F3600\n", Controller::grbl);
  EXPECT_NEAR(p.cycle_time, 100.0 / 60 + 60.0 / 500, 5e-3);
  EXPECT_EQ(p.blocks, 1u);
  EXPECT_NEAR(spent(p, TimeLimit::acceleration), 60.0 / 500, 1e-3);
}

// The same in Klipper, whose times are exact: 100/60 + 60/1000.
TEST(Predict, ALoneLineOfKlipperIsExact) {
  const auto p = predict_with(kKlipper, "G1 X100 F3600\n", Controller::klipper);
  EXPECT_NEAR(p.cycle_time, 100.0 / 60 + 60.0 / 1000, 1e-9);
}

// Z as slow as it may: 10 mm at 10 mm/s with 100 mm/s²: 10/10 + 10/100.
TEST(Predict, KlipperKeepsZsOwnLimits) {
  const auto p = predict_with(kKlipper, "G1 Z10 F6000\n", Controller::klipper);
  EXPECT_NEAR(p.cycle_time, 1.1, 1e-9);
  EXPECT_GT(spent(p, TimeLimit::axis_speed), 0.8);
}

// A right angle is passed at 5 mm/s, two lines of 50 mm at 50 mm/s: each 50/50 + 50/1000/2 + (50 − 5)/1000/2 + (5/1000)²…
// By hand: ramp up 0.05 s over 1.25 mm; ramp to 5 mm/s 0.045 s over (2500 − 25)/2000 = 1.2375 mm; the rest at 50 mm/s.
TEST(Predict, KlipperPassesASquareCornerAtItsVelocity) {
  const auto p = predict_with(kKlipper, "G1 X50 F3000\nG1 Y50\n", Controller::klipper);
  EXPECT_NEAR(p.cycle_time, 2 * (0.05 + 0.045 + (50 - 1.25 - 1.2375) / 50), 1e-9);
  EXPECT_NEAR(spent(p, TimeLimit::corner), 0.045, 1e-9);
}

TEST(Predict, FHoldsForRapidsOfPrinters) {
  const auto p = predict_with(kKlipper, "G0 X100 F1200\nG0 X0\n", Controller::klipper);
  EXPECT_NEAR(p.feed_time, 2 * (100.0 / 20 + 20.0 / 1000), 1e-9);
}

// Filament is drawn back 2 mm at 40 mm/s between two strokes of 50 mm at 50 mm/s, each from rest to rest: 50/50 +
// 50/1000. The extruder alone: 2/40 + 40/1500 with its own acceleration.
TEST(Predict, KlippersExtruderAloneBeginsAndEndsAtRest) {
  const std::string settings = std::string(kKlipper) +
                               "[extruder]\nnozzle_diameter: 0.4\nfilament_diameter: 1.75\n"
                               "max_extrude_only_velocity: 60\nmax_extrude_only_accel: 1500\n";
  const std::string program = "M83\nG1 X50 E2 F3000\nG1 E-2 F2400\nG1 X100 E2 F3000\n";
  EXPECT_NEAR(predict_with(settings.c_str(), program, Controller::klipper).cycle_time,
              2 * (1.0 + 0.05) + 2.0 / 40 + 40.0 / 1500, 1e-6);
  EXPECT_NEAR(predict_with(kKlipper, program, Controller::klipper).cycle_time, 100.0 / 50 + 0.05, 1e-6)
      << "no extruder";
}

// The extruder's speed may jump by 1 mm/s: from 0.04 mm a mm to none that is passed at 25 mm/s and not at 50.
TEST(Predict, KlippersExtruderSlowsChangesOfFlow) {
  const std::string settings = std::string(kKlipper) + "[extruder]\nnozzle_diameter: 0.4\nfilament_diameter: 1.75\n";
  const auto time = [&](const char* end) {
    const std::string program = std::string("M82\nG92 E0\nG1 X50 E2 F3000\nG1 X100 ") + end;
    return predict_with(settings.c_str(), program, Controller::klipper).cycle_time;
  };
  EXPECT_NEAR(time("E4\n"), 2.05, 1e-6);
  // Down to 25 mm/s and up again: 25 ms each over (2500 − 625)/2000 mm instead of at 50 mm/s.
  EXPECT_NEAR(time("E2\n") - time("E4\n"), 2 * (0.025 - 1875.0 / 2000 / 50), 1e-6);
}

TEST(Predict, M400IsAStopOfPrinters) {
  const double with = predict_with(kKlipper, "G1 X50 F3000\nM400\nG1 X100\n", Controller::klipper).cycle_time;
  const double without = predict_with(kKlipper, "G1 X50 F3000\nG1 X100\n", Controller::klipper).cycle_time;
  EXPECT_NEAR(with - without, 50.0 / 1000, 1e-9) << "slowing down from 50 mm/s, and speeding up again";
}

TEST(Predict, GrblDwellsInStepsAndRestsAfterEachMotion) {
  const auto p = predict_with(kGrbl, "G21 G90\nG1 X10 F1200\nG4 P0.12\nG1 X20\n", Controller::grbl);
  EXPECT_NEAR(p.dwell_time, 0.15, 1e-12);
  EXPECT_GE(spent(p, TimeLimit::stops), 0.025) << "$1";
  const auto hal = predict_with(kGrbl, "G21 G90\nG1 X10 F1200\nG4 P0.12\nG1 X20\n", Controller::grblhal);
  EXPECT_NEAR(p.cycle_time - hal.cycle_time, 0.025, 2e-3);
}

TEST(Predict, GrblWaitsForItsSpindleAndNotForNothing) {
  const std::string turning = "G21 G90\nM3 S1000\nG1 X10 F1200\nM3 S2000\nG1 X20\n";
  const std::string steady = "G21 G90\nM3 S1000\nG1 X10 F1200\nM3 S1000\nG1 X20\n";
  EXPECT_GT(predict_with(kGrbl, turning, Controller::grbl).cycle_time,
            predict_with(kGrbl, steady, Controller::grbl).cycle_time + 0.025);
}

TEST(Predict, TimesByLimitAddUp) {
  for (const auto& [settings, controller] :
       {std::pair(kGrbl, Controller::grbl), std::pair(kGrbl, Controller::grblhal),
        std::pair(kLinuxcnc, Controller::linuxcnc), std::pair(kKlipper, Controller::klipper),
        std::pair(kMarlin, Controller::marlin)}) {
    const bool is_printer = dialect_of(controller) == Dialect::marlin;
    PredictOptions options;
    options.keeps_blocks = true;
    const auto p = predict_with(settings, random_program(7, 400, is_printer), controller, options);
    EXPECT_NEAR(sum(p), p.cycle_time, 1e-9);
    EXPECT_NEAR(p.dwell_time, 1.0, 1e-9);
    EXPECT_NEAR(p.feed_time + p.rapid_time + p.dwell_time + spent(p, TimeLimit::stops), p.cycle_time, 0.5);
    EXPECT_NEAR(std::accumulate(p.row_time.begin(), p.row_time.end(), 0.0), p.cycle_time, 0.5);
  }
}

// No motion is faster than its feed.
TEST(Predict, NothingBeatsTheFeed) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    for (const auto& [settings, controller] :
         {std::pair(kGrbl, Controller::grbl), std::pair(kKlipper, Controller::klipper),
          std::pair(kMarlin, Controller::marlin), std::pair(kLinuxcnc, Controller::linuxcnc)}) {
      // Blends of LinuxCNC cut corners, so that the way is shorter.
      const std::string program = (controller == Controller::linuxcnc ? "G61\n" : "") +
                                  random_program(seed, 200, dialect_of(controller) == Dialect::marlin);
      ReadOptions options;
      options.dialect = dialect_of(controller);
      const auto reading = read_text(program, "p.nc", options);
      double bound = 0;
      for (std::size_t i = 0; i < reading->moves.size(); ++i) {
        if (reading->moves.kind[i] != MoveKind::feed) continue;
        bound += (reading->moves.end[i] - reading->moves.begin_of(i)).head<3>().norm() / reading->moves.feed[i];
      }
      // Rounding to steps changes lengths by a few 1e-3.
      EXPECT_GE(predict_with(settings, program, controller).cycle_time, bound * 0.995) << "seed " << seed;
    }
  }
}

// Klipper's corner speed does not hang on its acceleration at a right angle; what it may do more it does.
TEST(Predict, MoreAccelerationAloneNeverCostsTimeInKlipper) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::string program = random_program(seed, 200, true);
    double before = 1e9;
    for (const char* accel : {"500", "1000", "2000", "4000"}) {
      const std::string settings = "[printer]\nmax_velocity: 100\nmax_accel: " + std::string(accel) +
                                   "\nmax_z_accel: 100000\nmax_z_velocity: 1000\nminimum_cruise_ratio: 0\n";
      const double time = predict_with(settings.c_str(), program, Controller::klipper).cycle_time;
      EXPECT_LE(time, before * (1 + 1e-9)) << "seed " << seed << " at " << accel;
      before = time;
    }
  }
}

TEST(Predict, ALongerRingNeverCostsTime) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::string program = random_program(seed, 300, false);
    double before = 1e9;
    for (const char* blocks : {"30", "100", "400"}) {
      const std::string settings = std::string(kGrbl) + "$398=" + blocks + "\n";
      const double time = predict_with(settings.c_str(), program, Controller::grblhal).cycle_time;
      EXPECT_LE(time, before * (1 + 1e-9)) << "seed " << seed << " with " << blocks;
      before = time;
    }
  }
}

TEST(Predict, ASlowLinkStarvesShortBlocks) {
  std::string program = "G21 G90\nG1 F3000\n";
  for (int i = 1; i <= 500; ++i) program += "G1 X" + std::to_string(0.05 * i) + " Y0.000000\n";
  PredictOptions slow, fast;
  slow.baud = 9600;
  fast.baud = 1e9;
  const auto starved = predict_with(kGrbl, program, Controller::grbl, slow);
  const auto fed = predict_with(kGrbl, program, Controller::grbl, fast);
  // 500 lines of 25 bytes at 960 bytes a second.
  EXPECT_GE(starved.cycle_time, 0.9 * static_cast<double>(program.size()) / 960);
  EXPECT_GT(starved.starved, 10);
  EXPECT_GT(spent(starved, TimeLimit::link), 5);
  EXPECT_LT(fed.starved, 0.05);
}

TEST(Predict, ArcsWithoutTheirSectionAreRefusedByKlipper) {
  const char* bare = "[printer]\nmax_velocity: 100\nmax_accel: 1000\n";
  const auto settings = parse_controller_settings(bare, "printer.cfg");
  ReadOptions options;
  options.dialect = Dialect::marlin;
  const std::string program = "G1 X1 F600\nG2 X3 Y0 I1 J0\n";
  const auto p = predict(*read_text(program, "p.gcode", options), scan_program(program), *settings);
  ASSERT_FALSE(p);
  EXPECT_EQ(p.error().code, "controller-refuses");
  EXPECT_EQ(p.error().where.line, 2u);
}

// By hand: start and end at √(a/(2·80)) = 2.5 mm/s, 50 mm/s and 1000 mm/s²: ramps of 47.5 ms over (2500 − 6.25)/2000 mm.
TEST(Predict, MarlinStartsWithASpeed) {
  const auto p = predict_with(kMarlin, "G1 X100 F3000\n", Controller::marlin);
  EXPECT_NEAR(p.cycle_time, 2 * 0.0475 + (100 - 2 * 2493.75 / 2000) / 50, 1e-9);
}

// 200 mm at 100 mm/s: 2 s, and a ramp's time: v/a where it stops exactly, v/(a/2) where it might blend. [TRAJ]'s acceleration
// of 1 mm/s² bounds nothing.
TEST(Predict, LinuxcncHalvesTheAccelerationOfWhatMayBlend) {
  EXPECT_NEAR(predict_with(kLinuxcnc, "G61\nG0 X200\nM2\n", Controller::linuxcnc).cycle_time, 2.1, 5e-3);
  EXPECT_NEAR(predict_with(kLinuxcnc, "G64\nG0 X200\nM2\n", Controller::linuxcnc).cycle_time, 2.2, 5e-3);
}

TEST(Predict, LinuxcncsStartupCodeHoldsUntilTheProgramSaysElse) {
  const std::string startup = std::string(kLinuxcnc) + "[RS274NGC]\nRS274NGC_STARTUP_CODE = G21 G61\n";
  EXPECT_NEAR(predict_with(startup.c_str(), "G0 X200\nM2\n", Controller::linuxcnc).cycle_time, 2.1, 5e-3);
  EXPECT_NEAR(predict_with(startup.c_str(), "G64\nG0 X200\nM2\n", Controller::linuxcnc).cycle_time, 2.2, 5e-3);
}

// A square corner: with more tolerance it is rounded faster, and lines between points of a line are one.
TEST(Predict, ToleranceBuysTimeInLinuxcnc) {
  double before = 1e9;
  for (const char* mode : {"G64 P0.01", "G64 P0.1", "G64 P1"}) {
    const double time =
        predict_with(kLinuxcnc, std::string(mode) + "\nF6000\nG1 X50\nG1 Y50\nG1 X0\nG1 Y0\nM2\n", Controller::linuxcnc)
            .cycle_time;
    EXPECT_LT(time, before) << mode;
    before = time;
  }
  std::string points = "G64 P0.01\nF6000\n";
  for (int i = 1; i <= 50; ++i) points += "G1 X" + std::to_string(i) + "\n";
  EXPECT_EQ(predict_with(kLinuxcnc, points, Controller::linuxcnc).blocks, 1u);
}

TEST(Predict, EIsFollowedAsPrintersDo) {
  const ProgramText text =
      scan_program("G1 X1 E1\nG1 X2 E3 ; E9\nG92 E0\nG1 E.5\nM83\nG1 E-2\nM82\nG1 E0\nG91\nG1 E1\nG20\ng1 e1\n");
  const std::vector<float> fed = {1, 2, 0, 0.5F, 0, -2, 0, 1.5F, 0, 1, 0, 25.4F};
  ASSERT_EQ(text.extrusion.size(), fed.size());
  for (std::size_t i = 0; i < fed.size(); ++i) EXPECT_FLOAT_EQ(text.extrusion[i], fed[i]) << "line " << i + 1;
}

TEST(Predict, CommentsHideCodes) {
  const ProgramText text = scan_program("G1 X1 (M3 S5)\nm400 ; G28\nG92X0\r\nS100 M03\nG54.1");
  EXPECT_EQ(text.codes, (std::vector<std::uint8_t>{0, kFinishCode, kOriginCode, kSpindleCode, kOffsetCode}));
  EXPECT_EQ(text.bytes, (std::vector<std::uint16_t>{14, 11, 7, 9, 5}));
}

// An axis that the .ini does not have used to be run for ever: nothing bounds it.
TEST(Predict, LeavesOutMovesOfAxesThatLinuxcncHasNot) {
  const Prediction p =
      predict_with(kLinuxcnc, "G21 G90\nG1 X10 F600\nG1 A90 F100\nG1 X0 F600\nM2\n", Controller::linuxcnc);
  const Prediction without = predict_with(kLinuxcnc, "G21 G90\nG1 X10 F600\nG1 X0 F600\nM2\n", Controller::linuxcnc);
  EXPECT_DOUBLE_EQ(p.cycle_time, without.cycle_time);
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings.front().code, "axis-absent");
  EXPECT_EQ(p.warnings.front().where.line, 3u);
}

// Those models move X, Y and Z: a fourth axis was left out without a word, and the setpoints beside it were not.
TEST(Predict, TellsWhereItsModelLeavesRotaryAxesOut) {
  const std::string program = "G21 G90\nG1 X10 F600\nG1 X0 A90 F600\nG1 A0\nM2\n";
  const std::string straight = "G21 G90\nG1 X10 F600\nG1 X0 F600\nM2\n";
  const std::pair<Controller, const char*> all[] = {
      {Controller::grbl, "$110=6000\n$120=500\n"},
      {Controller::grblhal, "$110=6000\n$120=500\n"},
      {Controller::klipper, "[printer]\nmax_velocity: 100\nmax_accel: 1000\n"},
      {Controller::marlin, "echo: M203 X100 Y100 Z10\necho: M201 X1000 Y1000 Z100\n"}};
  for (const auto& [controller, settings] : all) {
    const auto told = [](const Prediction& p) {
      std::vector<std::size_t> lines;
      for (const Diagnostic& d : p.warnings) {
        if (d.code == "axis-absent") lines.push_back(d.where.line);
      }
      return lines;
    };
    EXPECT_EQ(told(predict_with(settings, program, controller)), std::vector<std::size_t>{3})
        << controller_title(controller);
    EXPECT_TRUE(told(predict_with(settings, straight, controller)).empty()) << controller_title(controller);
  }
}

// A move of 10⁷ cycles that all change the speed is one row.
TEST(Predict, IsCancelledWithinAMoveOfLinuxcnc) {
  const auto settings = parse_controller_settings(
      "[TRAJ]\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 100\n[AXIS_X]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 0.001\n",
      "settings", Controller::linuxcnc);
  ASSERT_TRUE(settings) << settings.error().message;
  const std::string program = "G21 G90\nG1 X1000000 F6000\nM2\n";
  ReadOptions reading;
  reading.dialect = Dialect::linuxcnc;
  const auto read = read_text(program, "p.nc", reading);
  ASSERT_TRUE(read);
  std::stop_source stop;
  int told = 0;
  const Monitor monitor{stop.get_token(), [&](double) {
                          ++told;
                          stop.request_stop();
                        }};
  const auto prediction = predict(*read, scan_program(program), *settings, {}, monitor);
  ASSERT_FALSE(prediction);
  EXPECT_EQ(prediction.error().kind, ErrorKind::cancelled);
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace toolpace
