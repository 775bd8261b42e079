#pragma once
/// What this build calls itself.

namespace toolpace {

/// "0.1.0", and where it was built in a checkout, the commit behind it: "0.1.0 (1a2b3c4)".
const char* version();

}  // namespace toolpace
