#include "toolpace/verify/derivative_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace {
namespace {

constexpr double kPositionUlps = 4;   // of a difference of two positions, in the file's unit and in ours
constexpr double kQuotientUlps = 16;  // of the quotients: a period that was rounded, three times, and units

}  // namespace

DerivativeCheck::DerivativeCheck(double period) : period_(period) {
  for (auto& order : worst_) order.fill(Worst(0.0));
}

void DerivativeCheck::take(const RowStream& stream) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!stream.rows().position[axis].empty()) take_axis(stream, axis);
  }
}

void DerivativeCheck::take_axis(const RowStream& stream, std::size_t axis) {
  const auto& rows = stream.rows();
  const double* const p = rows.position[axis].data();
  for (std::size_t order = 0; order < kDerivatives; ++order)
    used_[order][axis] |= !rows.derivative[order][axis].empty();
  for (std::size_t i = stream.begin(); i < stream.end(); ++i) {
    if (!stream.is_real(i)) continue;
    largest_[axis] = std::max(largest_[axis], std::abs(p[i]));
    const double d0 = p[i] - p[i - 1], d1 = p[i - 1] - p[i - 2], d2 = p[i - 2] - p[i - 3];
    const std::array<double, kDerivatives> difference = {d0, d0 - d1, (d0 - d1) - (d1 - d2)};
    const std::array<double, kDerivatives> extent = {std::abs(d0), std::abs(d0) + std::abs(d1),
                                                     std::abs(d0) + 2 * std::abs(d1) + std::abs(d2)};
    double per = 1.0, positions = 1.0;
    for (std::size_t order = 0; order < kDerivatives; ++order) {
      per /= period_;
      positions *= 2;
      const auto& column = rows.derivative[order][axis];
      if (column.empty()) continue;
      const double off = std::abs(column[i] - difference[order] * per);
      if (!worst_[order][axis].would_take(off, 0.0)) continue;
      const double noise =
          kEpsilon * (kPositionUlps * positions * largest_[axis] + kQuotientUlps * extent[order]) * per;
      worst_[order][axis].take(off, noise, stream, i);
    }
  }
}

void DerivativeCheck::report(VerifyReport& report) const {
  constexpr std::array kKinds = {CheckKind::speed_column, CheckKind::acceleration_column, CheckKind::jerk_column};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    for (std::size_t order = 0; order < kDerivatives; ++order) {
      if (used_[order][axis]) report.checks.push_back(worst_[order][axis].named(kKinds[order], axis));
    }
  }
}

}  // namespace toolpace
