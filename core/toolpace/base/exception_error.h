#pragma once
/// Exceptions as error values: at the end of each thread, nothing may be thrown.

#include "toolpace/base/result.h"

namespace toolpace {

/// What is being thrown, as an error. To be called in a catch block. Codes: out-of-memory; internal, for what should not be.
Error caught_error();

}  // namespace toolpace
