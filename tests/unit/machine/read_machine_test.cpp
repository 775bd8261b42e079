#include "toolpace/machine/read_machine.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace toolpace {
namespace {

constexpr const char* kIni =
    "[EMC]\nMACHINE = old lathe\n[TRAJ]\nLINEAR_UNITS = inch\nMAX_LINEAR_VELOCITY = 2\nMAX_LINEAR_ACCELERATION = 10\n"
    "[EMCMOT]\nSERVO_PERIOD = 2000000\n[AXIS_X]\nMAX_VELOCITY = 1 # fast\nMAX_ACCELERATION = 5\nMIN_LIMIT = -4\n"
    "MAX_LIMIT = 4\n[JOINT_1]\nMAX_JERK = 0\nMIN_LIMIT = -1e99\nMAX_LIMIT = 2\n";
constexpr const char* kDump =
    "Grbl 1.1f ['$' for help]\n$0=10\n$11=0.020 (junction deviation, mm)\n$100=250.000\n$110=6000.000\n$120=500.000\n"
    "$130=300.000\n$131=0\nok\n";

TEST(ReadMachine, ALinuxcncConfigurationIsConvertedToMillimetres) {
  const auto setup = import_linuxcnc_ini(kIni, "lathe.ini");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.name, "old lathe");
  EXPECT_EQ(setup->machine.path.speed, 50.8);
  EXPECT_EQ(setup->machine.path.deceleration, 254);
  EXPECT_EQ(setup->machine.axes[0].speed, 25.4);
  EXPECT_EQ(setup->machine.axes[0].acceleration, 127.0);
  EXPECT_EQ(setup->machine.axes[0].travel_min, -101.6);
  EXPECT_EQ(setup->machine.axes[1].travel_min, -kUnlimited);
  EXPECT_EQ(setup->machine.axes[1].travel_max, 50.8);
  EXPECT_EQ(setup->machine.axes[1].jerk, kUnlimited);
  EXPECT_EQ(setup->machine.period, 0.002);
  EXPECT_EQ(setup->options.law, LawKind::trapezoid) << "no jerk limit stands in it";
}

// LinuxCNC takes a name, or the units in a millimetre: 0.03937… of inches. Anything else would be wrong by 25.4 or more.
TEST(ReadMachine, UnitsOfAConfigurationAreNamedOrCountedAndNeverGuessed) {
  const auto speed_of = [](const std::string& units) {
    return import_linuxcnc_ini("[TRAJ]\nLINEAR_UNITS = " + units + "\n[AXIS_X]\nMAX_VELOCITY = 2\n", "mill.ini");
  };
  for (const char* inch : {"inch", "in", "Imperial", "inch  # of the old frame"})
    EXPECT_EQ(speed_of(inch)->machine.axes[0].speed, 50.8) << inch;
  for (const char* metric : {"mm", "METRIC", "1", "1.0"})
    EXPECT_EQ(speed_of(metric)->machine.axes[0].speed, 2) << metric;
  EXPECT_NEAR(speed_of("0.03937007874016")->machine.axes[0].speed, 50.8, 1e-9);
  for (const char* wrong : {"", "furlong", "0", "-1", "nan", "1e308"}) {
    const auto setup = speed_of(wrong);
    ASSERT_FALSE(setup) << wrong;
    EXPECT_EQ(setup.error().code, "import-value");
    EXPECT_EQ(setup.error().where.line, 2U);
    EXPECT_NE(setup.error().message.find("mm, inch"), std::string::npos) << setup.error().message;
  }
}

/// Limits of joints alone, of JOINT_0 on.
std::string joints(std::initializer_list<const char*> limits) {
  std::string text;
  int joint = 0;
  for (const char* limit : limits) text += "[JOINT_" + std::to_string(joint++) + "]\n" + limit + "\n";
  return text;
}

TEST(ReadMachine, JointsAreTheAxesThatTheirKinematicsSay) {
  const std::string two = joints({"MAX_VELOCITY = 10", "MAX_VELOCITY = 20"});
  const auto lathe = import_linuxcnc_ini("[KINS]\nKINEMATICS = trivkins coordinates=xz kinstype=BOTH\n" + two, "l.ini");
  ASSERT_TRUE(lathe) << lathe.error().message;
  EXPECT_EQ(lathe->machine.axes[0].speed, 10);
  EXPECT_EQ(lathe->machine.axes[1].speed, kUnlimited);
  EXPECT_EQ(lathe->machine.axes[2].speed, 20);
  EXPECT_TRUE(lathe->warnings.empty());

  // Without letters those of all axes, whatever [TRAJ] COORDINATES are: kins(9).
  const auto plain = import_linuxcnc_ini("[KINS]\nKINEMATICS = trivkins\n[TRAJ]\nCOORDINATES = X Z\n" + two, "p.ini");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->machine.axes[1].speed, 20);
  EXPECT_EQ(plain->machine.axes[2].speed, kUnlimited);

  const auto by_order = import_linuxcnc_ini("[TRAJ]\nCOORDINATES = Z X # turned round\n" + two, "o.ini");
  ASSERT_TRUE(by_order);
  EXPECT_EQ(by_order->machine.axes[0].speed, 20);
  EXPECT_EQ(by_order->machine.axes[2].speed, 10);
  EXPECT_TRUE(by_order->warnings.empty());
}

TEST(ReadMachine, OfTheJointsOfAGantryTheStrictestCounts) {
  const auto setup = import_linuxcnc_ini(
      "[KINS]\nKINEMATICS = trivkins coordinates=XYYZ\n" +
          joints({"MAX_VELOCITY = 10", "MAX_VELOCITY = 30\nMAX_JERK = 0\nMIN_LIMIT = -5\nMAX_LIMIT = 90",
                  "MAX_VELOCITY = 20\nMAX_JERK = 700\nMIN_LIMIT = -1\nMAX_LIMIT = 100", "MAX_VELOCITY = 40"}),
      "gantry.ini");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->machine.axes[1].speed, 20);
  EXPECT_EQ(setup->machine.axes[1].jerk, 700) << "0 is no limit";
  EXPECT_EQ(setup->machine.axes[1].travel_min, -1);
  EXPECT_EQ(setup->machine.axes[1].travel_max, 90);
  EXPECT_EQ(setup->machine.axes[2].speed, 40);
}

TEST(ReadMachine, AWrongLimitOfAGantryIsToldByTheJointThatHasIt) {
  const auto setup = import_linuxcnc_ini(
      "[KINS]\nKINEMATICS = trivkins coordinates=XX\n" + joints({"MAX_VELOCITY = -3", "MAX_VELOCITY = 5"}),
      "gantry.ini");
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().message, "JOINT_0.MAX_VELOCITY makes max_speed_mm_s -3, but it must be 1e-6 to 1e9 mm/s");
  EXPECT_EQ(setup.error().where.line, 4u);
}

TEST(ReadMachine, AnAxisThatNoFileNamesIsGuessedWithAWarning) {
  const auto setup = import_linuxcnc_ini(joints({"MAX_VELOCITY = 10", "MAX_VELOCITY = 20"}), "m.ini");
  ASSERT_TRUE(setup);
  EXPECT_EQ(setup->machine.axes[1].speed, 20);
  ASSERT_EQ(setup->warnings.size(), 1u);
  EXPECT_EQ(setup->warnings.front().code, "joint-axis-guessed");
  EXPECT_EQ(setup->warnings.front().severity, Severity::warning);
  EXPECT_TRUE(import_linuxcnc_ini("[AXIS_X]\nMAX_VELOCITY = 10\n", "m.ini")->warnings.empty()) << "nothing to guess";
}

TEST(ReadMachine, JointsThatAreNoAxesAreLeftOutWithAWarning) {
  const auto setup = import_linuxcnc_ini("[KINS]\nKINEMATICS = scarakins\n[AXIS_Y]\nMAX_VELOCITY = 7\n" +
                                             joints({"MAX_VELOCITY = 10", "MAX_VELOCITY = 20"}),
                                         "scara.ini");
  ASSERT_TRUE(setup);
  EXPECT_EQ(setup->machine.axes[0].speed, kUnlimited);
  EXPECT_EQ(setup->machine.axes[1].speed, 7);
  ASSERT_EQ(setup->warnings.size(), 1u);
  EXPECT_EQ(setup->warnings.front().code, "joint-axis-unknown");
  EXPECT_EQ(setup->warnings.front().where.line, 2u);
}

TEST(ReadMachine, GrblsSettingsAreTakenOver) {
  const auto setup = import_grbl_dump(kDump, "dump.txt");
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->options.corner.rule, CornerRule::junction);
  EXPECT_EQ(setup->options.corner.junction_deviation, 0.02);
  EXPECT_EQ(setup->machine.axes[0].speed, 100.0);  // 6000 mm/min
  EXPECT_EQ(setup->machine.axes[0].acceleration, 500.0);
  EXPECT_EQ(setup->machine.axes[0].travel_min, -300.0);
  EXPECT_EQ(setup->machine.axes[0].travel_max, 0.0);
  EXPECT_EQ(setup->machine.axes[0].steps_per_unit, 250.0);
  EXPECT_EQ(setup->machine.axes[1].travel_min, -kUnlimited);
}

TEST(ReadMachine, WhoseFileItIsIsToldByItsExtensionAndElseByItsText) {
  EXPECT_EQ(machine_format("a.TOML", kDump), MachineFormat::toml);
  EXPECT_EQ(machine_format("a.Ini", "[path]\n"), MachineFormat::linuxcnc);
  EXPECT_EQ(machine_format("settings.txt", kDump), MachineFormat::grbl);
  EXPECT_EQ(machine_format("config", kIni), MachineFormat::linuxcnc);
  EXPECT_EQ(machine_format("-", "[path]\nmax_speed_mm_s = 1\n"), MachineFormat::toml);
  EXPECT_EQ(machine_format("empty", ""), MachineFormat::toml);
  EXPECT_EQ(machine_format("printer.cfg", "[printer]\nmax_velocity: 300\n"), MachineFormat::klipper);
  EXPECT_EQ(machine_format("report", "echo: M203 X500 Y500 Z5\n"), MachineFormat::marlin);
}

TEST(ReadMachine, TravelOutOfOrderIsRefusedWithItsLine) {
  const auto setup = import_linuxcnc_ini("[AXIS_X]\nMIN_LIMIT = 100\nMAX_LIMIT = -100\n", "m.ini");
  ASSERT_FALSE(setup);
  EXPECT_EQ(setup.error().code, "import-value");
  EXPECT_EQ(setup.error().kind, ErrorKind::usage);
  EXPECT_EQ(setup.error().where.line, 3u);
  EXPECT_EQ(
      setup.error().message,
      "AXIS_X.MAX_LIMIT makes travel_mm [100, -100], but it must be [min, max] with min < max, each -1e9 to 1e9 mm, "
      "or -inf and inf for open ends");
}

TEST(ReadMachine, ValuesThatMakeNoSenseAreRefusedWithTheirBoundsAndLine) {
  const auto message = [](const auto& setup) { return setup ? std::string() : setup.error().message; };
  EXPECT_EQ(message(import_linuxcnc_ini("[TRAJ]\nMAX_VELOCITY = nan\n", "m.ini")),
            "TRAJ.MAX_VELOCITY makes max_speed_mm_s nan, but it must be 1e-6 to 1e9 mm/s");
  EXPECT_EQ(message(import_linuxcnc_ini("[TRAJ]\nMAX_VELOCITY = fast\n", "m.ini")),
            "TRAJ.MAX_VELOCITY is 'fast', which is no number");
  EXPECT_EQ(message(import_linuxcnc_ini("[EMCMOT]\nSERVO_PERIOD = 0\n", "m.ini")),
            "EMCMOT.SERVO_PERIOD makes period_ms 0, but it must be 0.001 to 10000 ms");
  EXPECT_EQ(message(import_grbl_dump("$120=-5\n", "m.txt")),
            "$120 makes max_acceleration_mm_s2 -5, but it must be 1e-6 to 1e12 mm/s²");
  EXPECT_EQ(import_grbl_dump("ok\n$110=inf\n", "m.txt").error().where.line, 2u);
  EXPECT_EQ(import_grbl_dump("$130=-5\n", "m.txt").error().code, "import-value");
}

TEST(ReadMachine, AFileWithoutLimitsIsNone) {
  EXPECT_EQ(import_linuxcnc_ini("[X]\na = b\n", "x.ini").error().code, "import-empty");
  EXPECT_EQ(import_grbl_dump("hello\n", "x.txt").error().code, "import-empty");
}

TEST(ReadMachine, AnImportedMachineCanBeSavedWhateverItsNameIsWrittenIn) {
  const auto setup = import_linuxcnc_ini("[EMC]\nMACHINE = Fr\xe4se\n[TRAJ]\nMAX_VELOCITY = 5\n", "m.ini");
  ASSERT_TRUE(setup);
  EXPECT_EQ(setup->machine.name, "Fr?se");
  EXPECT_TRUE(format_setup(*setup));
}

TEST(ReadMachine, FilesThatCannotBeReadAreIoErrors) {
  EXPECT_EQ(read_machine("no/such/machine.toml").error().kind, ErrorKind::io);
  EXPECT_EQ(read_machine(".").error().kind, ErrorKind::io);
}

TEST(ReadMachine, AFileOfMoreThanAMebibyteIsNoMachine) {
  const auto file = std::filesystem::temp_directory_path() / "toolpace-long-machine.ini";
  std::ofstream(file) << std::string((std::size_t{1} << 20) + 1, '#');
  EXPECT_EQ(read_machine(file).error().code, "machine-syntax");
  std::filesystem::remove(file);
}

TEST(ReadMachine, PrintersAreMachinesToo) {
  const auto klipper = parse_machine(
      "[printer]\nmax_velocity: 300\nmax_accel: 4000\nmax_z_velocity: 15\nmax_z_accel: 100\n", "printer.cfg");
  ASSERT_TRUE(klipper) << klipper.error().message;
  EXPECT_EQ(klipper->machine.path.speed, 300);
  EXPECT_EQ(klipper->machine.path.acceleration, 4000);
  EXPECT_EQ(klipper->machine.axes[2].speed, 15);
  EXPECT_EQ(klipper->machine.axes[0].speed, 300) << "as the path: a printer has X and Y, though no key of theirs";
  EXPECT_EQ(klipper->machine.axes[1].speed, 300);
  EXPECT_EQ(klipper->machine.axes[0].acceleration, kUnlimited);
  EXPECT_EQ(klipper->options.law, LawKind::trapezoid);
  const auto marlin =
      parse_machine("echo: M203 X200 Y210 Z5\necho: M201 X1000 Y1100 Z50\necho: M204 P800 T900\n", "report");
  ASSERT_TRUE(marlin) << marlin.error().message;
  EXPECT_EQ(marlin->machine.axes[1].speed, 210);
  EXPECT_EQ(marlin->machine.axes[2].acceleration, 50);
  EXPECT_EQ(marlin->machine.path.acceleration, 800);
}

}  // namespace
}  // namespace toolpace
