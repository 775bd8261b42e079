#include "preview/raster.h"

#include <algorithm>
#include <cmath>

namespace toolpace::ui {

LineRaster::LineRaster(QImage& image, double width, bool smooth)
    : pixels_(reinterpret_cast<QRgb*>(image.bits())),
      stride_(static_cast<int>(image.bytesPerLine() / 4)),
      columns_(image.width()),
      rows_(image.height()),
      width_(std::max(width, 1.0)),
      smooth_(smooth) {}

// Liang and Barsky 1984, on the image grown by the line's width.
bool LineRaster::clip(Ends& e) const {
  const double grow = width_ + 1;
  const double dx = e.x1 - e.x0, dy = e.y1 - e.y0;
  if (!std::isfinite(dx) || !std::isfinite(dy)) return false;
  const double p[4] = {-dx, dx, -dy, dy};
  const double q[4] = {e.x0 + grow, columns_ + grow - e.x0, e.y0 + grow, rows_ + grow - e.y0};
  double enter = 0, leave = 1;
  for (int side = 0; side < 4; ++side) {
    if (p[side] == 0) {
      if (q[side] < 0) return false;
    } else if (p[side] < 0) {
      enter = std::max(enter, q[side] / p[side]);
    } else {
      leave = std::min(leave, q[side] / p[side]);
    }
  }
  if (enter > leave) return false;
  e = {e.x0 + enter * dx, e.y0 + enter * dy, e.x0 + leave * dx, e.y0 + leave * dy};
  return true;
}

void LineRaster::draw(double x0, double y0, double x1, double y1, QRgb colour) {
  Ends ends{x0, y0, x1, y1};
  if (!clip(ends)) return;
  smooth_ ? draw_smooth(ends, colour) : draw_plain(ends, colour);
}

void LineRaster::draw_plain(const Ends& e, QRgb colour) {
  const int thick = static_cast<int>(std::lround(width_));
  const double dx = e.x1 - e.x0, dy = e.y1 - e.y0;
  const bool steep = std::abs(dy) > std::abs(dx);
  const int steps = static_cast<int>(std::max(std::abs(dx), std::abs(dy))) + 1;
  // 16.16 fixed point; the clipped coordinates are small enough for it.
  const double shift = (thick - 1) / 2.0;
  auto x = static_cast<std::int32_t>((e.x0 - (steep ? shift : 0)) * 65536.0);
  auto y = static_cast<std::int32_t>((e.y0 - (steep ? 0 : shift)) * 65536.0);
  const auto step_x = static_cast<std::int32_t>(dx / steps * 65536.0);
  const auto step_y = static_cast<std::int32_t>(dy / steps * 65536.0);
  for (int i = 0; i <= steps; ++i, x += step_x, y += step_y) {
    for (int k = 0; k < thick; ++k) {
      const int column = (x >> 16) + (steep ? k : 0), row = (y >> 16) + (steep ? 0 : k);
      if (static_cast<unsigned>(column) < static_cast<unsigned>(columns_) &&
          static_cast<unsigned>(row) < static_cast<unsigned>(rows_)) {
        pixels_[row * stride_ + column] = colour;
      }
    }
  }
}

void LineRaster::blend(int x, int y, QRgb colour, int alpha) {
  if (static_cast<unsigned>(x) >= static_cast<unsigned>(columns_) ||
      static_cast<unsigned>(y) >= static_cast<unsigned>(rows_)) {
    return;
  }
  QRgb& under = pixels_[y * stride_ + x];
  const auto channel = [&](int shift) {
    const int a = static_cast<int>((under >> shift) & 0xffu), b = static_cast<int>((colour >> shift) & 0xffu);
    return static_cast<QRgb>(a + (b - a) * alpha / 256) << shift;
  };
  under = 0xff000000u | channel(16) | channel(8) | channel(0);
}

// Coverage along the minor axis, pixel column by pixel column: exact for the sides of the line, square at its ends.
void LineRaster::draw_smooth(const Ends& e, QRgb colour) {
  const bool steep = std::abs(e.y1 - e.y0) > std::abs(e.x1 - e.x0);
  double u0 = steep ? e.y0 : e.x0, w0 = steep ? e.x0 : e.y0, u1 = steep ? e.y1 : e.x1, w1 = steep ? e.x1 : e.y1;
  if (u0 > u1) {
    std::swap(u0, u1);
    std::swap(w0, w1);
  }
  const double slope = u1 > u0 ? (w1 - w0) / (u1 - u0) : 0.0;
  const double half = width_ / 2 * std::sqrt(1 + slope * slope);
  // A point still shows as a dot, and joints close.
  const double overlap = std::max(width_ / 2 - 0.5, (1.0 - (u1 - u0)) / 2);
  const double from = u0 - std::max(overlap, 0.0), to = u1 + std::max(overlap, 0.0);
  const int limit = steep ? rows_ : columns_;
  const int first = std::max(static_cast<int>(std::floor(from)), 0);
  const int last = std::min(static_cast<int>(std::ceil(to)), limit);
  for (int u = first; u < last; ++u) {
    const double along = std::min<double>(u + 1, to) - std::max<double>(u, from);
    if (along <= 0) continue;
    const double middle = w0 + (std::clamp(u + 0.5, u0, u1) - u0) * slope;
    const double low = middle - half, high = middle + half;
    for (int w = static_cast<int>(std::floor(low)); w < high; ++w) {
      const double across = std::min<double>(w + 1, high) - std::max<double>(w, low);
      const int alpha = static_cast<int>(256 * along * across);
      steep ? blend(w, u, colour, alpha) : blend(u, w, colour, alpha);
    }
  }
}

double LineRaster::draw_dashed(double x0, double y0, double x1, double y1, QRgb colour, double on, double off,
                               double phase) {
  const double length = std::hypot(x1 - x0, y1 - y0), period = on + off;
  if (!std::isfinite(length)) return phase;
  const double end_phase = std::fmod(phase + length, period);
  Ends e{x0, y0, x1, y1};
  if (length <= 0 || !clip(e)) return end_phase;
  const double skipped = std::hypot(e.x0 - x0, e.y0 - y0), visible = std::hypot(e.x1 - e.x0, e.y1 - e.y0);
  const double ux = (x1 - x0) / length, uy = (y1 - y0) / length;
  double place = -std::fmod(phase + skipped, period);
  for (; place < visible; place += period) {
    const double from = std::max(place, 0.0), to = std::min(place + on, visible);
    if (to > from) draw(e.x0 + ux * from, e.y0 + uy * from, e.x0 + ux * to, e.y0 + uy * to, colour);
  }
  return end_phase;
}

}  // namespace toolpace::ui
