#include "toolpace/machine/read_machine.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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

}  // namespace
}  // namespace toolpace
