#include "toolpace/base/exception_error.h"

#include <exception>
#include <new>
#include <system_error>

namespace toolpace {
namespace {

Error out_of_memory() {
  return {ErrorKind::input,
          "out-of-memory",
          "there is not enough memory for this",
          "split the program, or give more memory",
          {},
          {}};
}

Error internal(const std::string& what) {
  return {ErrorKind::input, "internal", "internal error" + what, "please report it", {}, {}};
}

}  // namespace

Error caught_error() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::system_error& e) {
    // A thread that cannot be started, too, is a lack of memory.
    const bool lacks =
        e.code() == std::errc::not_enough_memory || e.code() == std::errc::resource_unavailable_try_again;
    return lacks ? out_of_memory() : internal(std::string(": ") + e.what());
  } catch (const std::exception& e) {
    return internal(std::string(": ") + e.what());
  } catch (...) {
    return internal({});
  }
}

}  // namespace toolpace
