#pragma once
/// The core's words for the numbers that it is given, and the flags that gave them.

#include <span>
#include <string_view>

#include "toolpace/base/result.h"

namespace toolpace::cli {

struct FlagName {
  std::string_view quantity;  ///< as a message of the core begins: "the length"
  std::string_view flag;      ///< "--length"
};

/// The error of a number that the core refused, with the flag that gave it in front: "--length: the length is -1". Others are as
/// they were.
Error with_flag(Error error, std::span<const FlagName> names);

}  // namespace toolpace::cli
