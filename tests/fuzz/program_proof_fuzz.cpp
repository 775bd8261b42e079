/// A program, and setpoints that claim to run it: whatever they are, an error or a report. A line "%%" parts the two.

#include <cmath>
#include <cstdlib>

#include "scratch_file.h"
#include "toolpace/io/setpoint_reader.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/build_path.h"
#include "toolpace/verify/verify.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toolpace;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t parting = text.find("\n%%\n");
  if (parting == std::string_view::npos) return 0;
  ReadOptions options;
  options.limits = {.call_depth = 5, .loop_turns = 100, .blocks = 500, .lines = 500};
  const auto reading = read_text(text.substr(0, parting), "fuzz.ngc", options);
  if (!reading) return 0;
  const auto path = build_path(reading->moves, 0.0);
  if (!path) return 0;
  static const auto name = fuzz::scratch_file(".csv");
  fuzz::fill(name, text.substr(parting + 4));
  const auto file = open_setpoint_file(name);
  if (!file) return 0;
  const ProgrammedPath program{*path, reading->moves, 0.01};
  const auto report = verify(**file, default_setup().machine, &program);
  if (!report) return 0;
  if (report->rows == 0) std::abort();
  for (const Check& check : report->checks) {
    if (std::isnan(check.value) || std::isnan(check.bound)) std::abort();
  }
  return 0;
}
