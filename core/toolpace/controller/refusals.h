#pragma once
/// Lines that a controller would refuse, in its own words.

#include <string>
#include <vector>

#include "toolpace/machine/controller.h"
#include "toolpace/nc/reading.h"

namespace toolpace {

struct Refusal {
  std::size_t line = 0;
  int number = 0;       ///< of grbl's error codes
  std::string message;  ///< what grbl says it means

  /// "error:20", as it comes back to the sender
  std::string code() const { return "error:" + std::to_string(number); }
};

/// What the reader found fault with that grbl or grblHAL would refuse: errors, and some that are warnings here because the rest of
/// the program can still be understood. The controller leaves out such a line and goes on; senders mostly stop. Other controllers
/// have no numbers: none.
std::vector<Refusal> refusals(Controller controller, const Reading& reading);

}  // namespace toolpace
