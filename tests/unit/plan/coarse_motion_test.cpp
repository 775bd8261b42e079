#include "toolpace/plan/smooth/coarse_motion.h"

#include <gtest/gtest.h>

namespace toolpace {
namespace {

using detail::tube::basis;
using detail::tube::basis_bend;
using detail::tube::basis_slope;
using Window = detail::tube::MotionWindow<2>;
using Vec = Window::Vec;

/// A wave, in motion at both ends.
Window wave(std::size_t points) {
  Window m;
  m.rest_begin = m.rest_end = false;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = static_cast<double>(k);
    m.c.emplace_back(0.3 * t + std::sin(0.11 * t), std::cos(0.07 * t));
  }
  for (double u = 1.7; u < static_cast<double>(points) - 2; u += 3.1) m.pass.push_back(u);
  return m;
}

Vec place(const Window& m, double u) {
  double t;
  const std::size_t k = m.cell(u, t);
  return m.combine(k, basis(t));
}

TEST(CoarseMotion, IsTheSameOnStepsHalfAsLong) {
  Window m = wave(40);
  m.stride = 2;
  const Window half = detail::tube::halved(m);
  EXPECT_EQ(half.stride, 1u);
  EXPECT_EQ(half.size(), 77u);  // twice the 37 intervals, and 3
  for (double u = 1; u <= 38; u += 0.21) {
    EXPECT_LE((place(half, 2 * u - 1) - place(m, u)).norm(), 1e-13) << u;
  }
  for (std::size_t i = 0; i < m.pass.size(); ++i) EXPECT_DOUBLE_EQ(half.pass[i], 2 * m.pass[i] - 1);
}

TEST(CoarseMotion, KeepsPlaceSpeedAndAccelerationAtEndsInMotion) {
  const Window m = wave(163), coarse = detail::tube::coarsened(m, 4);
  EXPECT_EQ(coarse.size(), 43u);  // 160 intervals are 40 of four
  for (const bool at_end : {false, true}) {
    const std::size_t k = at_end ? m.size() - 3 : 1, q = at_end ? coarse.size() - 3 : 1;
    const double t = at_end ? 1 : 0;
    EXPECT_LE((coarse.combine(q, basis(t)) - m.combine(k, basis(t))).norm(), 1e-12);
    EXPECT_LE((coarse.combine(q, basis_slope(t)) - 4 * m.combine(k, basis_slope(t))).norm(), 1e-12);
    EXPECT_LE((coarse.combine(q, basis_bend(t)) - 16 * m.combine(k, basis_bend(t))).norm(), 1e-12);
  }
}

TEST(CoarseMotion, StaysNearTheMotionAndPassesVerticesInOrder) {
  const Window m = wave(150), coarse = detail::tube::coarsened(m, 4);
  ASSERT_EQ(coarse.pass.size(), m.pass.size());
  for (std::size_t i = 0; i < m.pass.size(); ++i) {
    // Four steps of 0.11 rad of a wave of 1: what cubic pieces leave is below 0.11⁴·4⁴/384.
    EXPECT_LE((place(coarse, coarse.pass[i]) - place(m, m.pass[i])).norm(), 2e-3) << i;
    EXPECT_GE(coarse.pass[i], coarse.pass[i > 0 ? i - 1 : 0]);
  }
}

}  // namespace
}  // namespace toolpace
