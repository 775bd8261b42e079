#pragma once
/// What a block assigns to parameters: "#1 = …", "#<name> = …".

#include <vector>

#include "toolpace/nc/text/expression.h"

namespace toolpace::nc {

class Assignments {
 public:
  Assignments(Parameters& parameters, FaultSink& faults, ExpressionReader& expressions)
      : parameters_(parameters), faults_(faults), expressions_(expressions) {}

  void clear() { list_.clear(); }
  bool empty() const { return list_.empty(); }

  /// Reads one; the cursor stands on the '#'. It is not made yet.
  bool read(Scanner& text);

  /// Makes all of them. @return false after recording a fault
  bool make();

 private:
  struct Assignment {
    ExpressionReader::Target target;
    double value;
    std::size_t column;
  };

  Parameters& parameters_;
  FaultSink& faults_;
  ExpressionReader& expressions_;
  std::vector<Assignment> list_;
};

}  // namespace toolpace::nc
