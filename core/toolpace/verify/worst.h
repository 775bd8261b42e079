#pragma once
/// The worst value of one check, while rows go by.

#include <cmath>
#include <cstdint>
#include <limits>

#include "toolpace/verify/report.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// Relative slack on every limit: for the rounding of the limits themselves (percent, unit conversions), and for phases of
/// a plan that meet with a gap of some 1e-12 mm, which three differences at 1 ms turn into 1e-2 mm/s³.
inline constexpr double kLimitSlack = 1e-6;

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

inline double threshold(double limit, double bound) { return limit * (1 + kLimitSlack) + bound; }

/// Keeps the row that exceeds its own limit + bound by most, else the largest value.
class Worst {
 public:
  explicit Worst(double limit = std::numeric_limits<double>::infinity()) { check_.limit = limit; }

  bool would_take(double value, double bound) const {
    return value > check_.value || value > threshold(check_.limit, bound);
  }

  void take(double value, double bound, const RowStream& stream, std::size_t local) {
    const bool broken = value > threshold(check_.limit, bound);
    if (seen_ && (broken < check_.broken || value <= check_.value)) return;
    seen_ = true;
    check_.value = value;
    check_.bound = bound;
    check_.broken = broken;
    check_.row = stream.row_in_file(local);
    if (!stream.rows().time.empty()) check_.time = stream.rows().time[local];
    if (!stream.rows().line.empty()) check_.line = stream.rows().line[local];
  }

  const Check& check() const { return check_; }
  Check named(CheckKind kind, std::optional<std::size_t> axis = {}) const {
    Check result = check_;
    result.kind = kind;
    result.axis = axis;
    return result;
  }

 private:
  Check check_;
  bool seen_ = false;
};

}  // namespace toolpace
