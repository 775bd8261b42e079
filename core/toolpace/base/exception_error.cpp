#include "toolpace/base/exception_error.h"

#include <exception>
#include <new>

namespace toolpace {

Error caught_error() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {ErrorKind::input,
            "out-of-memory",
            "there is not enough memory for this",
            "split the program, or give more memory",
            {},
            {}};
  } catch (const std::exception& e) {
    return {ErrorKind::input, "internal", std::string("internal error: ") + e.what(), "please report it", {}, {}};
  } catch (...) {
    return {ErrorKind::input, "internal", "internal error", "please report it", {}, {}};
  }
}

}  // namespace toolpace
