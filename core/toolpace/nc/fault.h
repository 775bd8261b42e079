#pragma once
/// Something wrong with the block being read, before its place in a file is known.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "toolpace/base/result.h"

namespace toolpace::nc {

struct Fault {
  const char* code = "";  ///< stable key
  std::string message;
  std::string remedy;
  std::size_t column = 0;  ///< from 1; 0 = the block as a whole
  Severity severity = Severity::error;
};

/// Collects the faults of one block. Reading stops at the first error of a block; warnings may be several.
class FaultSink {
 public:
  /// Records an error. Returns false, so that a reading function can end with `return faults.fail(…)`.
  bool fail(const char* code, std::string message, std::string remedy = {}, std::size_t column = 0) {
    add(code, message, remedy, column, Severity::error);
    return false;
  }
  void warn(const char* code, std::string message, std::string remedy = {}, std::size_t column = 0) {
    add(code, message, remedy, column, Severity::warning);
  }
  bool empty() const { return faults_.empty(); }
  std::vector<Fault>& list() { return faults_; }
  void clear() { faults_.clear(); }

 private:
  void add(const char* code, std::string& message, std::string& remedy, std::size_t column, Severity severity) {
    Fault& fault = faults_.emplace_back();
    fault = {code, std::move(message), std::move(remedy), column, severity};
  }

  std::vector<Fault> faults_;
};

}  // namespace toolpace::nc
