#include "controller_flags.h"

#include <fmt/format.h>

#include "interrupt.h"
#include "toolpace/base/numbers.h"

namespace toolpace::cli {
namespace {

constexpr double kMostBaud = 1e12;
constexpr double kMostBlockTime = 1e6;  // [ms]

std::string controller_names() {
  std::string names;
  for (const Controller c : all_controllers()) names += (names.empty() ? "" : ", ") + std::string(controller_name(c));
  return names;
}

}  // namespace

void ControllerFlags::add_to(Command& command, Need need) {
  command.input("--settings FILE", settings, "the settings file",
                "The controller's own settings: an answer to $$, a printer.cfg, a report of M503, a LinuxCNC .ini",
                need);
  command.word("--controller NAME", controller, "One of " + controller_names() + "; default: as the settings tell");
  command.number("--baud B", baud, "Serial link, bit/s at 10 bits a byte; default: blocks are always there");
  command.number("--block-time-ms T", block_time_ms, "What the controller needs to read a block; default 0");
}

Result<ControllerSettings> ControllerFlags::read_settings() const {
  std::optional<Controller> whose;
  if (!controller.empty()) {
    whose = controller_named(controller);
    if (!whose) {
      return tl::unexpected(usage_error("bad-flag", fmt::format("--controller knows no '{}'", controller),
                                        "give one of " + controller_names()));
    }
  }
  return read_controller_settings(settings, whose, terminal_monitor("settings"));
}

Result<PredictOptions> ControllerFlags::options() const {
  PredictOptions options;
  const auto check = [](const char* flag, double value, double most, const char* remedy,
                        bool may_be_0) -> Result<void> {
    if ((value > 0 || (may_be_0 && value == 0)) && value <= most) return {};
    return tl::unexpected(
        usage_error("bad-flag",
                    fmt::format("{} is {}, but it must be {} and at most {}", flag, toolpace::to_text(value),
                                may_be_0 ? "at least 0" : "above 0", toolpace::to_text(most)),
                    remedy));
  };
  if (baud) {
    if (auto fine = check("--baud", *baud, kMostBaud, "leave it out where blocks are always there", false); !fine)
      return tl::unexpected(fine.error());
    options.baud = baud;
  }
  if (block_time_ms) {
    if (auto fine = check("--block-time-ms", *block_time_ms, kMostBlockTime, "give milliseconds", true); !fine)
      return tl::unexpected(fine.error());
    options.block_time = *block_time_ms * 1e-3;
  }
  return options;
}

}  // namespace toolpace::cli
