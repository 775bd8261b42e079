#pragma once
/// Errors as values: what went wrong, where, and what to do about it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace toolpace {

/// A place in a text. Lines and columns count from 1; 0 = unknown.
struct Location {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Who has to act, and with it the exit code of the command line (CLI: usage 2, input 3, infeasible 3, io 4, cancelled
/// 130).
enum class ErrorKind : std::uint8_t { usage, input, infeasible, io, cancelled };

struct Error {
  ErrorKind kind = ErrorKind::input;
  std::string code;     ///< stable key such as "arc-radius-too-small"; translations hang on it
  std::string message;  ///< what is wrong, English, one sentence without a full stop
  std::string remedy;   ///< what to do about it, may be empty
  Location where = {};
  std::optional<double> attainable = {};  ///< for infeasible: the nearest value that would work
};

template <class T>
using Result = tl::expected<T, Error>;

enum class Severity : std::uint8_t { note, warning, error };

/// Something to say about an input that was read. Reading collects every diagnostic and goes on.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;
  std::string message;
  std::string remedy;
  Location where;
  std::string excerpt;  ///< the offending text, shortened, may be empty
};
using Diagnostics = std::vector<Diagnostic>;

}  // namespace toolpace
