#pragma once
/// Parts of a motion, and joining them again.

#include "toolpace/plan/smooth/motion_window.h"

namespace toolpace::detail::tube {

/// Knots begin … end of a motion, with the vertices that are passed in between.
template <int D>
MotionWindow<D> part(const MotionWindow<D>& m, std::size_t begin, std::size_t end) {
  MotionWindow<D> r;
  r.c.assign(m.c.begin() + static_cast<std::ptrdiff_t>(begin) - 1, m.c.begin() + static_cast<std::ptrdiff_t>(end) + 2);
  r.stride = m.stride;
  const auto at = [&](std::size_t knot) {
    return std::lower_bound(m.pass.begin(), m.pass.end(), static_cast<double>(knot));
  };
  const auto low = begin > 1 ? at(begin) : m.pass.begin(), high = end + 2 < m.size() ? at(end) : m.pass.end();
  r.first = m.first + static_cast<std::size_t>(low - m.pass.begin());
  r.pass.reserve(static_cast<std::size_t>(high - low));
  for (auto u = low; u < high; ++u) r.pass.push_back(*u - static_cast<double>(begin) + 1);
  r.rest_begin = begin == 1 && m.rest_begin;
  r.rest_end = end + 2 == m.size() && m.rest_end;
  return r;
}

/// Appends a motion that goes on where the other ends: three control points are shared.
template <int D>
void join(MotionWindow<D>& a, const MotionWindow<D>& b) {
  const double shift = static_cast<double>(a.size()) - 3;
  a.c.insert(a.c.end(), b.c.begin() + 3, b.c.end());
  for (const double u : b.pass) a.pass.push_back(u + shift);
  a.rest_end = b.rest_end;
}

/// As join(), but also to nothing.
template <int D>
void append(MotionWindow<D>& a, const MotionWindow<D>& b) {
  if (a.size() > 0) {
    join(a, b);
  } else {
    a = b;
  }
}

/// Puts a part that has been bent, but not hurried, back to where it was taken.
/// @param from, vertex  its first control point and vertex there
template <int D>
void put(MotionWindow<D>& m, const MotionWindow<D>& part, std::size_t from, std::size_t vertex) {
  std::copy(part.c.begin(), part.c.end(), m.c.begin() + static_cast<std::ptrdiff_t>(from));
  for (std::size_t i = 0; i < part.pass.size(); ++i) m.pass[vertex + i] = part.pass[i] + static_cast<double>(from);
}

/// Control points left… of a and …right of b, with the stop between them.
template <int D>
MotionWindow<D> seam(const MotionWindow<D>& a, std::size_t left, const MotionWindow<D>& b, std::size_t right) {
  MotionWindow<D> m;
  m.rest_begin = m.rest_end = false;
  m.first = a.first;
  m.c.assign(a.c.begin() + static_cast<std::ptrdiff_t>(left), a.c.end());
  for (const double u : a.pass) {
    if (u < static_cast<double>(left) + 1) {
      ++m.first;
    } else {
      m.pass.push_back(u - static_cast<double>(left));
    }
  }
  m.pass.push_back(static_cast<double>(m.c.size()) - 2);
  const double shift = static_cast<double>(m.c.size()) - 3;  // the stop's three points are shared
  m.c.insert(m.c.end(), b.c.begin() + 3, b.c.begin() + static_cast<std::ptrdiff_t>(right));
  for (const double u : b.pass) {
    if (u < static_cast<double>(right) - 2) m.pass.push_back(u + shift);
  }
  return m;
}

}  // namespace toolpace::detail::tube
