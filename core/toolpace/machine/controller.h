#pragma once
/// The controllers whose settings are read, and whose cycle times are predicted.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace toolpace {

enum class Controller : std::uint8_t { grbl, grblhal, klipper, marlin, linuxcnc };

/// "grblhal": as flags and tables name it.
std::string_view controller_name(Controller controller);
/// "grblHAL": as people write it.
std::string_view controller_title(Controller controller);
std::optional<Controller> controller_named(std::string_view name);
std::span<const Controller> all_controllers();
/// Whether programs lie on the controller's own disk, so that no link can starve it.
bool reads_own_disk(Controller controller);

/// Whose settings a text is, by what stands in it: lines such as $110=6000 are grbl's ($ numbers that grbl has not:
/// grblHAL's), M203 with axes Marlin's, a [printer] with keys of Klipper its, [TRAJ] and its like LinuxCNC's. None where
/// nothing tells. Decorations of senders and consoles around the settings do not matter.
std::optional<Controller> controller_of_settings(std::string_view text);

}  // namespace toolpace
