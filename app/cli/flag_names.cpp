#include "flag_names.h"

#include <string>

namespace toolpace::cli {

Error with_flag(Error error, std::span<const FlagName> names) {
  const FlagName* best = nullptr;  // of "the jerk limit" and "the jerk limit while slowing down" the one that says more
  for (const FlagName& name : names) {
    const bool is_meant = error.message.rfind(name.quantity, 0) == 0;
    if (is_meant && (!best || name.quantity.size() > best->quantity.size())) best = &name;
  }
  if (best) error.message = std::string(best->flag) + ": " + error.message;
  return error;
}

}  // namespace toolpace::cli
