#include "toolpace/machine/controller_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "places.h"
#include "temporary_directory.h"
#include "toolpace/machine/read_machine.h"

namespace toolpace {
namespace {

using test::source_dir;
using testing::TemporaryDirectory;

bool has(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Result<ControllerSettings> read(const std::string& name) {
  return read_controller_settings(source_dir() / "tests/data/controllers/settings" / name);
}

TEST(ControllerSettings, EachFileTellsWhoseItIs) {
  EXPECT_EQ(read("grbl_g1.txt")->controller, Controller::grbl);
  EXPECT_EQ(read("klipper_k3.cfg")->controller, Controller::klipper);
  EXPECT_EQ(read("linuxcnc_L1.ini")->controller, Controller::linuxcnc);
  EXPECT_EQ(parse_controller_settings("$0=5\n$110=1000\n$398=100\n", "hal")->controller, Controller::grblhal);
  EXPECT_EQ(parse_controller_settings("echo:  M203 X500.00 Y500.00 Z5.00\n", "m503")->controller, Controller::marlin);
}

TEST(ControllerSettings, ThoseOfAnotherControllerAreNamedForWhatTheyAre) {
  const auto foreign = parse_controller_settings("[TRAJ]\nCOORDINATES = X Y Z\n", "mill.ini", Controller::grbl);
  ASSERT_FALSE(foreign);
  EXPECT_EQ(foreign.error().code, "settings-foreign");
  EXPECT_EQ(foreign.error().message, "these are settings of LinuxCNC, not of grbl");
  const auto none = parse_controller_settings("hello\n", "note.txt");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "settings-unknown");
}

TEST(ControllerSettings, OtherFilesAreNamedForWhatTheyAre) {
  const std::pair<const char*, const char*> files[] = {
      {"M203 X6000 Y6000\nM201 X500 Y500\nM566 X900 Y900\n", "RepRapFirmware"},  // its M203 counts in mm/min
      {"axes:\n  x:\n    max_rate_mm_per_min: 5000\n", "FluidNC"},
      {"alpha_steps_per_mm 80\n", "Smoothieware"},
      {"[machine]\nname = \"mill\"\n", "a machine file"},
      {"G21 G90\nG1 X1 F100\n", "an NC program"},
      {"\r\n", "an empty file"}};
  for (const auto& [text, kind] : files) {
    const auto refused = parse_controller_settings(text, "file");
    ASSERT_FALSE(refused) << text;
    EXPECT_EQ(refused.error().code, "settings-unknown");
    EXPECT_NE(refused.error().message.find(kind), std::string::npos) << refused.error().message;
  }
}

TEST(ControllerSettings, GrblSpeaksInMillimetresAMinute) {
  const auto settings = read("grbl_g1.txt");
  ASSERT_TRUE(settings);
  const auto& grbl = std::get<GrblSettings>(settings->values);
  EXPECT_DOUBLE_EQ(grbl.idle_delay, 0.025);
  EXPECT_DOUBLE_EQ(grbl.rate[0], 5000.0 / 60);
  EXPECT_DOUBLE_EQ(grbl.rate[2], 500.0 / 60);
  EXPECT_DOUBLE_EQ(grbl.steps[2], 400);
  EXPECT_DOUBLE_EQ(grbl.acceleration[2], 50);
  EXPECT_TRUE(settings->defaulted.empty());
  EXPECT_TRUE(has(settings->unused, "$130"));
  EXPECT_TRUE(settings->unknown.empty());
}

TEST(ControllerSettings, SectionsOfKlipperCountWithoutKeys) {
  const auto settings =
      parse_controller_settings("[printer]\nmax_velocity: 300\nmax_accel: 3000\n[gcode_arcs]\n", "p.cfg");
  ASSERT_TRUE(settings);
  EXPECT_TRUE(std::get<KlipperSettings>(settings->values).has_arcs);
  EXPECT_TRUE(settings->unused.empty() && settings->unknown.empty()) << "sections themselves are no settings";
}

TEST(ControllerSettings, WhatConsolesPutAroundDoesNotMatter) {
  for (const char* text :
       {"$110=6000.000\n$11=0.020\n",
        ">>> $$\n$110 = 6000.000    (X-axis maximum rate, mm/min)\n$11 = 0.020 (Junction)\nok\n",
        "[10:31:02] $110=6000.000 (x max rate, mm/min)\r\n[10:31:02] $11=0.020\r\n<Idle|MPos:0,0,0>\r\n",
        "$110=6000\r$11=0.02\r", "Setting,Value\n$110,6000,\"x, mm/min\"\n$11,0.02,\"-\"\n",
        "$110\t6000\tX\n$11\t0.02\tJ\n", "{\"a\": {\"$110\": 6000, \"$11\":0.02}}",
        "[{\"setting\":\"$110\",\"value\":\"6000\"},{\"setting\":\"$11\",\"value\":0.02}]",
        "[{\n \"key\": \"$110\",\n \"value\": \"6000\"\n},\n{\n \"key\": \"$11\",\n \"value\": \"0.02\"\n}]\n",
        "{\"$110\":\"6000.000\",\"$11\":\"0.020\"}", "{\n  \"$110\": \"6000.000\",\n  \"$11\": \"0.020\"\n}\n"}) {
    const auto settings = parse_controller_settings(text, "dump");
    ASSERT_TRUE(settings) << text;
    const auto& grbl = std::get<GrblSettings>(settings->values);
    EXPECT_DOUBLE_EQ(grbl.rate[0], 100.0) << text;
    EXPECT_DOUBLE_EQ(grbl.junction_deviation, 0.02) << text;
    EXPECT_DOUBLE_EQ(grbl.acceleration[0], 10.0) << "grbl's own default";
    EXPECT_TRUE(has(settings->defaulted, "$120")) << text;
    const auto machine = parse_machine(text, "dump");
    ASSERT_TRUE(machine) << text;
    EXPECT_DOUBLE_EQ(machine->machine.axes[0].speed, 100.0) << "`plan` reads the same dumps";
  }
}

TEST(ControllerSettings, OfSeveralDumpsTheLastOneCounts) {
  const auto settings = parse_controller_settings("$110=100\n$110=6000\n", "log");
  EXPECT_DOUBLE_EQ(std::get<GrblSettings>(settings->values).rate[0], 100.0);
}

TEST(ControllerSettings, ANumberThatIsNoneHasItsLine) {
  const auto bad = parse_controller_settings("$11=0.01\n$110=fast\n", "dump");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, "import-value");
  EXPECT_EQ(bad.error().where.line, 2u);
  const auto decimal_comma = parse_controller_settings("$11=0,010\n", "dump");
  ASSERT_FALSE(decimal_comma) << "no 0";
  EXPECT_NE(decimal_comma.error().message.find("0,010"), std::string::npos);
  const auto negative = parse_controller_settings("$110=-5\n", "dump");
  ASSERT_FALSE(negative);
  EXPECT_EQ(negative.error().code, "import-value");
}

TEST(ControllerSettings, TheGreetingTellsGrblhal) {
  EXPECT_EQ(parse_controller_settings("GrblHAL 1.1f ['$' or '$HELP' for help]\n$110=1000\n", "dump")->controller,
            Controller::grblhal);
}

TEST(ControllerSettings, KlipperDoesNotTakeWhatItsSectionHasNot) {
  const auto settings = parse_controller_settings(
      "[printer]\nmax_velocity: 300\nmax_velocty: 1\nmax_accel: 3000\n[fan]\npin: a\n", "p.cfg");
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->unknown, std::vector<std::string>{"[printer] max_velocty"});
  EXPECT_TRUE(has(settings->unused, "[fan] pin"));
}

TEST(ControllerSettings, AnIniTellsOfKeysThatStandTwice) {
  const auto settings = parse_controller_settings(
      "[TRAJ]\nLINEAR_UNITS = inch\nCOORDINATES = X Y\nMAX_LINEAR_VELOCITY = 1\nMAX_LINEAR_VELOCITY = 2\n[AXIS_X]\n"
      "MAX_VELOCITY = 3\nMAX_ACCELERATION = 4\n",
      "mill.ini");
  ASSERT_TRUE(settings);
  const auto& linuxcnc = std::get<LinuxcncSettings>(settings->values);
  EXPECT_DOUBLE_EQ(linuxcnc.velocity, 25.4) << "the first one counts";
  ASSERT_FALSE(settings->warnings.empty());
  EXPECT_EQ(settings->warnings.front().code, "settings-twice");
  // Y is there and has no limits: LinuxCNC's own are 1 of the file's units.
  EXPECT_EQ(settings->defaulted, (std::vector<std::string>{"[AXIS_Y] MAX_VELOCITY", "[AXIS_Y] MAX_ACCELERATION"}));
  EXPECT_DOUBLE_EQ(linuxcnc.axis_velocity[1], 25.4);
  const auto old = parse_controller_settings("[TRAJ]\nMAX_VELOCITY = 10\n[AXIS_0]\nMAX_VELOCITY = 10\n", "old.ini");
  ASSERT_FALSE(old);
  EXPECT_EQ(old.error().code, "settings-missing");
}

TEST(ControllerSettings, SaveConfigOverridesWhatStandsAbove) {
  const auto settings = parse_controller_settings(
      "[printer]\nmax_velocity: 300  # fast\nmax_accel = 3000\n#max_accel: 1\n\n[gcode_macro X]\ngcode:\n  M204 S1\n"
      "#*# <---------------------- SAVE_CONFIG ---------------------->\n#*# [printer]\n#*# max_accel = 4500\n",
      "printer.cfg");
  ASSERT_TRUE(settings) << settings.error().message;
  const auto& klipper = std::get<KlipperSettings>(settings->values);
  EXPECT_EQ(klipper.max_velocity, 300);
  EXPECT_EQ(klipper.max_accel, 4500);
  EXPECT_EQ(klipper.max_z_accel, 4500) << "that along the path where the file has none";
  EXPECT_EQ(klipper.square_corner_velocity, 5);
  EXPECT_FALSE(klipper.has_arcs);
}

TEST(ControllerSettings, TheCruiseRatioMayBeToldAsAnAcceleration) {
  const auto settings = parse_controller_settings(
      "[printer]\nmax_velocity: 300\nmax_accel: 4000\nmax_accel_to_decel: 1000\n", "printer.cfg");
  EXPECT_DOUBLE_EQ(std::get<KlipperSettings>(settings->values).minimum_cruise_ratio, 0.75);
}

TEST(ControllerSettings, AKeyWithoutDefaultIsAskedFor) {
  const auto settings = parse_controller_settings("[printer]\nmax_velocity: 300\n", "printer.cfg");
  ASSERT_FALSE(settings);
  EXPECT_EQ(settings.error().code, "settings-missing");
}

TEST(ControllerSettings, IncludesAreFollowed) {
  const TemporaryDirectory folder;
  std::ofstream(folder.path() / "printer.cfg") << "[include parts/*.cfg]\n[printer]\nmax_velocity: 300\n";
  std::filesystem::create_directory(folder.path() / "parts");
  std::ofstream(folder.path() / "parts/a.cfg") << "[printer]\nmax_accel: 1234\nmax_velocity: 1\n";
  std::ofstream(folder.path() / "parts/b.txt") << "[printer]\nmax_accel: 1\n";
  const auto klipper = read_controller_settings(folder.path() / "printer.cfg");
  ASSERT_TRUE(klipper) << klipper.error().message;
  EXPECT_EQ(std::get<KlipperSettings>(klipper->values).max_accel, 1234);
  EXPECT_EQ(std::get<KlipperSettings>(klipper->values).max_velocity, 300) << "what stands later counts";

  std::ofstream(folder.path() / "mill.ini") << "[TRAJ]\nLINEAR_UNITS = inch\n#INCLUDE axes.inc\n";
  std::ofstream(folder.path() / "axes.inc") << "[AXIS_X]\nMAX_VELOCITY = 2\nMAX_ACCELERATION = 10\n";
  const auto mill = read_controller_settings(folder.path() / "mill.ini");
  ASSERT_TRUE(mill) << mill.error().message;
  EXPECT_DOUBLE_EQ(std::get<LinuxcncSettings>(mill->values).axis_velocity[0], 50.8);

  std::ofstream(folder.path() / "lost.cfg") << "[include nowhere.cfg]\n[printer]\nmax_velocity: 1\nmax_accel: 1\n";
  const auto lost = read_controller_settings(folder.path() / "lost.cfg");
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().kind, ErrorKind::io);
}

TEST(ControllerSettings, AReportOfMarlinIsReadThroughItsEcho) {
  const auto settings = parse_controller_settings(
      "Recv: echo:; Linear Units:\necho:  G21 ; (mm)\necho:; Steps per unit:\necho: M92 X80.00 Y81.00 Z400.00 E93.00\n"
      "  M203 X200.00 Y210.00 Z12.00 E25.00\nRecv: echo:  M201 X1000.00 Y1100.00 Z120.00 E5000.00\n"
      "echo:  M204 P500.00 R1000.00 T700.00\necho:  M205 B20000.00 S0.00 T0.00 J0.02\n",
      "report");
  ASSERT_TRUE(settings) << settings.error().message;
  const auto& marlin = std::get<MarlinSettings>(settings->values);
  EXPECT_EQ(marlin.steps[1], 81);
  EXPECT_EQ(marlin.rate[2], 12);
  EXPECT_EQ(marlin.axis_acceleration[0], 1000);
  EXPECT_EQ(marlin.travel_acceleration, 700);
  EXPECT_EQ(marlin.junction_deviation, 0.02);
  EXPECT_TRUE(has(settings->unused, "M205 B"));
}

TEST(ControllerSettings, AReportOfMarlinInInchesIsRefused) {
  const std::string limits = "echo: M203 X11.81 Y11.81 Z0.20\n";
  for (const char* units : {"echo:  G20 ; (in)\n", "Recv: echo:  G20    ; Units in inches\r\n", "  G20\n"}) {
    const auto settings = parse_controller_settings("echo:; Linear Units:\n" + std::string(units) + limits, "report");
    ASSERT_FALSE(settings) << units;
    EXPECT_EQ(settings.error().code, "import-value");
    EXPECT_EQ(settings.error().where.line, 2U);
    EXPECT_NE(settings.error().remedy.find("G21"), std::string::npos);
    EXPECT_FALSE(parse_machine(units + limits, "report")) << "`plan` would be as wrong";
  }
  EXPECT_TRUE(parse_controller_settings("> G20\n" + limits + "> G21\necho:  G21 ; (mm), not G20\n" + limits, "log"))
      << "the last report counts";
}

TEST(ControllerSettings, EveryParameterCanBeTriedWithAnotherValue) {
  for (const char* name : {"grbl_g1.txt", "klipper_k1.cfg", "linuxcnc_L1.ini"}) {
    auto settings = *read(name);
    for (const ControllerParameter& p : parameters(settings)) {
      EXPECT_FALSE(p.key.empty());
      EXPECT_GT(p.size, 0);
      EXPECT_LE(p.least, p.most) << p.key;
    }
  }
}

}  // namespace
}  // namespace toolpace
