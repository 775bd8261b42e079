#include <fmt/format.h>

#include "toolpace/machine/key_text.h"
#include "toolpace/machine/kinematics_section.h"
#include "toolpace/machine/modes_section.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/setup_proof.h"

namespace toolpace {

Result<std::string> proven_text(std::string text, const Setup& setup, UnknownKeys unknown) {
  if (auto fine = check_setup(setup.machine, setup.options); !fine) return tl::unexpected(fine.error());
  const auto again = parse_setup(text, setup.machine.name, unknown);
  const auto difference = again ? first_difference(setup, *again) : again.error().message;
  if (!difference) return text;
  return tl::unexpected(Error{ErrorKind::usage,
                              "machine-unwritable",
                              "no machine file can hold this machine: " + *difference,
                              "give it a name in UTF-8 and limits in their ranges",
                              {},
                              {}});
}

Result<std::string> format_setup(const Setup& setup) {
  const auto sections = texts_of(setup), absent = texts_of_absent_keys(setup);
  std::string text;
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const bool only_differences = sections[s].name.starts_with("servo.");
    std::string body;
    for (std::size_t k = 0; k < sections[s].keys.size(); ++k) {
      const KeyText& key = sections[s].keys[k];
      const bool goes_without_saying = key == absent[s].keys[k] && (only_differences || is_none(key));
      if (key.name == kModesKey) continue;  // below, in sections of their own
      if (!goes_without_saying) body += fmt::format("{} = {}\n", key.name, key.text());
    }
    if (!body.empty()) text += fmt::format("{}[{}]\n{}", text.empty() ? "" : "\n", sections[s].name, body);
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::string modes = detail::modes_sections(kAxisNames[axis], setup.machine.servo[axis].modes, "\n");
    if (!modes.empty()) text += (text.empty() ? "" : "\n") + modes;
  }
  if (const std::string chain = detail::kinematics_text(setup.kinematics); !chain.empty()) text += "\n" + chain;
  return proven_text(std::move(text), setup, UnknownKeys::refuse);
}

}  // namespace toolpace
