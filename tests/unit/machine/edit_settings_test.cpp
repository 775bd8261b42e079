#include "toolpace/machine/edit_settings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "places.h"

namespace toolpace {
namespace {

/// What becomes of a text; the code of the error where it does not.
std::string edited(const std::string& text, Controller controller, const std::string& key, double value,
                   const std::map<std::string, std::string, std::less<>>& files = {}) {
  const auto included = [&](std::string_view name) {
    const auto at = files.find(name);
    return at == files.end() ? std::vector<std::string>{} : std::vector<std::string>{at->second};
  };
  const auto result = edit_controller_setting(text, "settings", controller, key, value, included);
  return result ? *result : result.error().code;
}

double value_of(const std::string& text, Controller controller, const std::string& key) {
  auto settings = parse_controller_settings(text, "settings", controller);
  for (const ControllerParameter& p : parameters(*settings)) {
    if (p.key == key) return *p.value / p.size;
  }
  return -1;
}

TEST(EditSettings, OfADumpOneNumberChangesInItsDecorations) {
  const std::string before =
      "[12:31:02] >>> $$\r\n<< $0=10\r\n<< $110=6000.000 (x max rate, mm/min)\r\n<< $120=500.000\r\nok\r\n";
  const std::string after =
      "[12:31:02] >>> $$\r\n<< $0=10\r\n<< $110=7500.000 (x max rate, mm/min)\r\n<< $120=500.000\r\nok\r\n";
  EXPECT_EQ(edited(before, Controller::grbl, "$110", 7500), after);
  EXPECT_EQ(edited(before, Controller::grbl, "$110", 6000), before);
  // Three decimals do not hold it.
  EXPECT_NE(edited(before, Controller::grbl, "$110", 0.0625).find("$110=0.0625 (x"), std::string::npos);
}

TEST(EditSettings, OfTwoDumpsInALogTheLastCounts) {
  EXPECT_EQ(edited("$110=1000\n$110=2000\n", Controller::grbl, "$110", 3000), "$110=1000\n$110=3000\n");
}

TEST(EditSettings, WhatADumpLacksGetsALineBehindItsLast) {
  EXPECT_EQ(edited("$110=6000\r\nok\r\n", Controller::grbl, "$12", 0.005), "$110=6000\r\n$12=0.005\r\nok\r\n");
  EXPECT_EQ(edited("{\"$110\":\"6000\"}", Controller::grbl, "$12", 0.005), "settings-unwritable");
  EXPECT_EQ(edited("{\"$12\":\"0.002\",\"$110\":\"6000\"}", Controller::grbl, "$110", 7000),
            "{\"$12\":\"0.002\",\"$110\":\"7000\"}");
}

TEST(EditSettings, WhatTheControllerDoesNotTakeIsRefused) {
  EXPECT_EQ(edited("$110=6000\n", Controller::grbl, "$110", -1), "import-value");
  EXPECT_EQ(edited("$110=6000\n", Controller::grbl, "$999", 1), "settings-unwritable");
  EXPECT_EQ(edited("hello\n", Controller::grbl, "$110", 1), "settings-unknown");
}

const std::string kPrinter =
    "# mine\n[printer]\nkinematics: cartesian\nmax_velocity = 300   # mm/s\nmax_accel: 3000 ; soft\n\n[fan]\npin: "
    "PA8\n";

TEST(EditSettings, OfAPrinterCfgCommentsAndMarksStay) {
  EXPECT_EQ(edited(kPrinter, Controller::klipper, "[printer] max_velocity", 350),
            "# mine\n[printer]\nkinematics: cartesian\nmax_velocity = 350   # mm/s\nmax_accel: 3000 ; soft\n\n[fan]\n"
            "pin: PA8\n");
  // A new key stands right below the header of its section.
  EXPECT_EQ(edited(kPrinter, Controller::klipper, "[printer] square_corner_velocity", 8).substr(0, 45),
            "# mine\n[printer]\nsquare_corner_velocity: 8\nki");
}

TEST(EditSettings, TheBlockOfSaveConfigIsEditedWhereItCounts) {
  const std::string text = kPrinter + "#*# <--- SAVE_CONFIG --->\n#*# [printer]\n#*# max_accel = 4000\n";
  EXPECT_EQ(edited(text, Controller::klipper, "[printer] max_accel", 5000),
            kPrinter + "#*# <--- SAVE_CONFIG --->\n#*# [printer]\n#*# max_accel = 5000\n");
  // Above the block, where people write.
  EXPECT_EQ(edited("[include a.cfg]\n#*# <--- SAVE_CONFIG --->\n#*# [probe]\n", Controller::klipper,
                   "[printer] max_z_accel", 50, {{"a.cfg", kPrinter}}),
            "[include a.cfg]\n[printer]\nmax_z_accel: 50\n#*# <--- SAVE_CONFIG --->\n#*# [probe]\n");
}

TEST(EditSettings, WhatStandsInAFileThatIsIncludedIsNotWrittenElsewhere) {
  const std::string text = "[include limits.cfg]\n[printer]\nkinematics: corexy\n";
  const std::string limits = "[printer]\nmax_velocity: 200\nmax_accel: 2000\n";
  EXPECT_EQ(edited(text, Controller::klipper, "[printer] max_accel", 2500, {{"limits.cfg", limits}}),
            "settings-included");
  // The file that comes last counts, which may be this one.
  EXPECT_EQ(
      edited(text + "max_accel: 1000\n", Controller::klipper, "[printer] max_accel", 2500, {{"limits.cfg", limits}}),
      text + "max_accel: 2500\n");
  // Of an .ini the first one counts.
  const std::string ini = "#INCLUDE more.inc\n[TRAJ]\nMAX_LINEAR_VELOCITY = 50\n[AXIS_X]\nMAX_VELOCITY = 10\n";
  const std::string more = "[TRAJ]\nMAX_LINEAR_VELOCITY = 40\n";
  EXPECT_EQ(edited(ini, Controller::linuxcnc, "[TRAJ] MAX_LINEAR_VELOCITY", 60, {{"more.inc", more}}),
            "settings-included");
}

TEST(EditSettings, WithoutArcsThereIsNoResolutionThatWouldTurnThemOn) {
  EXPECT_EQ(edited(kPrinter, Controller::klipper, "[gcode_arcs] resolution", 0.5), "settings-unwritable");
}

TEST(EditSettings, OfAReportOneWordChanges) {
  const std::string report =
      "echo:; Maximum feedrates (units/s):\necho:  M203 X500.00 Y500.00 Z5.00\necho:  M205 B20000.00 S0.00 J0.01\n";
  EXPECT_EQ(edited(report, Controller::marlin, "M203 Y", 450.5),
            "echo:; Maximum feedrates (units/s):\necho:  M203 X500.00 Y450.50 Z5.00\necho:  M205 B20000.00 S0.00 "
            "J0.01\n");
  const std::string with = edited(report, Controller::marlin, "M204 P", 800);
  EXPECT_EQ(with, report + "M204 P800\n");
  EXPECT_DOUBLE_EQ(value_of(with, Controller::marlin, "M204 P"), 800);
}

TEST(EditSettings, OfAnIniInchesStayInches) {
  const std::string ini =
      "[TRAJ]\nLINEAR_UNITS = inch\nMAX_VELOCITY = 4.0  # quick\n[KINS]\nKINEMATICS = trivkins coordinates=XYY\n"
      "[JOINT_0]\nMAX_VELOCITY = 2.0\n[JOINT_1]\nMAX_VELOCITY = 2.0\n[JOINT_2]\nMAX_VELOCITY = 3.0\n";
  // 50.8 mm/s are 2 inches a second.
  EXPECT_EQ(value_of(ini, Controller::linuxcnc, "[AXIS_Y] MAX_VELOCITY"), 50.8);
  EXPECT_EQ(edited(ini, Controller::linuxcnc, "[TRAJ] MAX_LINEAR_VELOCITY", 127).substr(27, 28),
            "MAX_VELOCITY = 5.0  # quick\n");
  // Both motors of a gantry.
  const std::string both = edited(ini, Controller::linuxcnc, "[AXIS_Y] MAX_VELOCITY", 63.5);
  EXPECT_NE(both.find("[JOINT_0]\nMAX_VELOCITY = 2.0\n[JOINT_1]\nMAX_VELOCITY = 2.5\n[JOINT_2]\nMAX_VELOCITY = 2.5\n"),
            std::string::npos)
      << both;
  // What no inch of ten digits is comes near enough.
  const std::string odd = edited(ini, Controller::linuxcnc, "[AXIS_X] MAX_VELOCITY", 30);
  EXPECT_NEAR(value_of(odd, Controller::linuxcnc, "[AXIS_X] MAX_VELOCITY"), 30, 1e-9);
}

TEST(EditSettings, WhatAnIniLacksGoesBelowItsSectionOrGetsOne) {
  const std::string ini = "[TRAJ]\nMAX_LINEAR_VELOCITY = 50\n[AXIS_X]\nMAX_VELOCITY = 10\n";
  EXPECT_EQ(edited(ini, Controller::linuxcnc, "[TRAJ] ARC_BLEND_ENABLE", 0),
            "[TRAJ]\nARC_BLEND_ENABLE = 0\nMAX_LINEAR_VELOCITY = 50\n[AXIS_X]\nMAX_VELOCITY = 10\n");
  EXPECT_EQ(edited(ini, Controller::linuxcnc, "[AXIS_B] MAX_ACCELERATION", 90),
            ini + "[AXIS_B]\nMAX_ACCELERATION = 90\n");
}

TEST(EditSettings, EveryParameterOfTheFilesThatWereMeasuredCanBeRaisedAndPutBack) {
  for (const char* name : {"grbl_g1.txt", "klipper_k1.cfg", "klipper_k3.cfg", "linuxcnc_L1.ini"}) {
    std::ifstream file(test::source_dir() / "tests/data/controllers/settings" / name);
    std::stringstream stream;
    stream << file.rdbuf();
    const std::string text = stream.str();
    auto settings = parse_controller_settings(text, name);
    ASSERT_TRUE(settings) << name;
    for (const std::string& key : settings->used) {
      const double before = value_of(text, settings->controller, key);
      if (!(before > 0)) continue;
      const double raised = key == "[printer] minimum_cruise_ratio" ? 0.25 : before == 1 ? before : before * 1.25;
      const std::string with = edited(text, settings->controller, key, raised);
      EXPECT_NEAR(value_of(with, settings->controller, key), raised, 1e-9 * raised) << name << ' ' << key << with;
      EXPECT_NEAR(value_of(edited(with, settings->controller, key, before), settings->controller, key), before,
                  1e-9 * before);
    }
  }
}

// [RS274NGC] RS274NGC_STARTUP_CODE is a line of codes; of it the number behind the P of G64 is a setting.
TEST(EditSettings, TheToleranceOfG64ChangesWithinTheStartupCode) {
  const auto code = [](const std::string& codes) {
    return "[TRAJ]\nMAX_LINEAR_VELOCITY = 50\n[AXIS_X]\nMAX_VELOCITY = 50\n[RS274NGC]\nRS274NGC_STARTUP_CODE = " +
           codes + "\n";
  };
  const auto lnc = Controller::linuxcnc;
  EXPECT_EQ(edited(code("G21 G64 P0.010 G90"), lnc, "G64 P", 0.05), code("G21 G64 P0.050 G90"));
  EXPECT_EQ(edited(code("g64p0.01q.002g21 ; as ever, P5"), lnc, "G64 P", 0.0125),
            code("g64p0.0125q.002g21 ; as ever, P5"));
  EXPECT_EQ(edited(code("G10 L2 P1 G61 G64 P0.01"), lnc, "G64 P", 0.02), code("G10 L2 P1 G61 G64 P0.02"));
  EXPECT_EQ(edited(code("G20 G64 P0.001"), lnc, "G64 P", 0.0508), code("G20 G64 P0.002"));
  EXPECT_DOUBLE_EQ(value_of(code("G20 G64 P0.001"), lnc, "G64 P"), 0.0254);
}

TEST(EditSettings, WithoutAToleranceOfG64ThereIsNoneToChange) {
  for (const char* codes :
       {"G21 G90", "G64", "G64 G10 L2 P1", "G64 P0.01 G61", "G64 P0.01 G61.1", "G64 P0.01 G64", "G61 ; G64 P0.01"}) {
    const std::string text =
        std::string(
            "[TRAJ]\nMAX_LINEAR_VELOCITY = 50\n[AXIS_X]\nMAX_VELOCITY = 50\n[RS274NGC]\nRS274NGC_STARTUP_CODE = ") +
        codes + "\n";
    EXPECT_EQ(edited(text, Controller::linuxcnc, "G64 P", 0.02), "settings-unwritable") << codes;
  }
}

}  // namespace
}  // namespace toolpace
