#include "toolpace/report/report_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr std::size_t kBins = 1000;
constexpr std::size_t kMostPoints = 6000;
constexpr double kWidth = 1000, kHeight = 170, kLeft = 70, kRight = 10, kTop = 22, kBottom = 24;
constexpr double kContourHeight = 620;
constexpr double kThinning = 1 / (8 * kWidth);  // of the contour's extent: an eighth of a pixel

/// Cividis, which people with colour-blindness can tell, in eight steps.
/// @source Nuñez, Anderton and Renslow 2018, "Optimizing colormaps with consideration for color vision deficiency"
constexpr std::array<const char*, 8> kCividis = {"#00224e", "#123570", "#3b496c", "#575d6d",
                                                 "#707173", "#a59c74", "#d2c060", "#fee838"};

/// 1, 2 or 5 times a power of ten, so that about `count` of them fill the range.
double tick_step(double range, int count) {
  const double rough = range / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power) return factor * power;
  }
  return 10 * power;
}

struct Scale {
  double low, high, from, to;  ///< values and pixels
  double operator()(double value) const { return from + (value - low) / (high - low) * (to - from); }
};

std::string ticks_svg(const Scale& x, const Scale& y, double duration) {
  std::string svg;
  const double dy = tick_step(y.high - y.low, 4);
  for (double v = std::ceil(y.low / dy) * dy; v <= y.high; v += dy) {
    const double value = std::abs(v) < dy / 1e6 ? 0.0 : v;
    svg += fmt::format(
        "<line class='{}' x1='{:.0f}' x2='{:.0f}' y1='{:.1f}' y2='{:.1f}'/><text class='y' x='{:.0f}' "
        "y='{:.1f}'>{:.6g}</text>",
        value == 0 ? "zero" : "grid", kLeft, kWidth - kRight, y(v), y(v), kLeft - 6, y(v) + 4, value);
  }
  const double dx = tick_step(duration, 8);
  for (int k = 0; k * dx <= duration; ++k) {
    svg += fmt::format("<text class='x' x='{:.1f}' y='{:.0f}'>{:.6g}</text>", x(k * dx), kHeight - 8, k * dx);
  }
  return svg;
}

}  // namespace

Envelope::Envelope(std::size_t rows) : rows_(std::max<std::size_t>(rows, 1)) {
  const std::size_t bins = std::min(rows_, kBins);
  low_.assign(bins, std::numeric_limits<double>::infinity());
  high_.assign(bins, -std::numeric_limits<double>::infinity());
}

void Envelope::add(std::size_t row, double value) {
  const std::size_t bin = std::min(row * low_.size() / rows_, low_.size() - 1);
  low_[bin] = std::min(low_[bin], value);
  high_[bin] = std::max(high_[bin], value);
}

std::string plot_svg(const Envelope& curve, double duration, const PlotText& text) {
  double low = 0, high = 0;
  for (std::size_t i = 0; i < curve.bins(); ++i) {
    low = std::min(low, curve.low(i));
    high = std::max(high, curve.high(i));
  }
  if (high - low <= 0) high = low + 1;
  const double margin = 0.05 * (high - low);
  const Scale y{low - (low < 0 ? margin : 0), high + margin, kHeight - kBottom, kTop};
  const double last = std::max(duration, 1e-9);
  const Scale x{0, last, kLeft, kWidth - kRight};
  const auto at = [&](std::size_t bin) {
    return x((static_cast<double>(bin) + 0.5) / static_cast<double>(curve.bins()) * last);
  };
  std::string path;
  for (std::size_t i = 0; i < curve.bins(); ++i)
    path += fmt::format("{}{:.1f} {:.1f}", i ? "L" : "M", at(i), y(curve.high(i)));
  for (std::size_t i = curve.bins(); i-- > 0;) path += fmt::format("L{:.1f} {:.1f}", at(i), y(curve.low(i)));
  return fmt::format("<svg class='plot' viewBox='0 0 {:.0f} {:.0f}' role='img' aria-label='{} over time'>", kWidth,
                     kHeight, text.title) +
         fmt::format("<text class='title' x='{:.0f}' y='14'>{}  {}</text>", kLeft, text.title, text.unit) +
         ticks_svg(x, y, last) + "<path class='curve' d='" + path + "Z'/></svg>\n";
}

ContourPicture::ContourPicture(double extent, double fastest)
    : tolerance_(std::max(extent, 1e-9) * kThinning), fastest_(fastest) {}

std::size_t ContourPicture::colour(double speed) const {
  const double share = fastest_ > 0 ? speed / fastest_ : 0.0;
  return std::min(static_cast<std::size_t>(std::max(0.0, share) * kCividis.size()), kCividis.size() - 1);
}

/// Whether the stretch so far may end in this point instead: it goes on the same way, at about the same speed.
bool ContourPicture::may_skip(const Point& point) const {
  const std::size_t n = points_.size();
  if (n < 2 || colour(point.speed) != colour(points_[n - 1].speed)) return false;
  double along = 0, square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = point.at[k] - points_[n - 2].at[k];
    along += d * direction_[k];
    square += d * d;
  }
  return along >= reached_ && square - along * along <= tolerance_ * tolerance_;
}

/// @source Reumann and Witkam 1974: a strip along the first direction
void ContourPicture::add(const std::array<double, 3>& point, double speed) {
  const Point next{point, speed};
  double square = 0;
  if (!points_.empty()) {
    for (std::size_t k = 0; k < 3; ++k) square += std::pow(point[k] - points_.back().at[k], 2);
    if (square <= tolerance_ * tolerance_ / 16) return;
  }
  if (may_skip(next)) {
    points_.back() = next;
  } else {
    points_.push_back(next);
    const double length = std::sqrt(square);
    const std::size_t n = points_.size();
    for (std::size_t k = 0; n > 1 && k < 3; ++k) direction_[k] = (point[k] - points_[n - 2].at[k]) / length;
  }
  if (points_.size() > 1) {
    reached_ = 0;
    for (std::size_t k = 0; k < 3; ++k) reached_ += (point[k] - points_[points_.size() - 2].at[k]) * direction_[k];
  }
  if (points_.size() > kMostPoints) thin();
}

/// Once more, in a strip twice as wide.
void ContourPicture::thin() {
  ContourPicture coarser(2 * tolerance_ / kThinning, fastest_);
  for (const Point& p : points_) coarser.add(p.at, p.speed);
  // What a page cannot hold even so is thinned by number.
  if (coarser.points_.size() > kMostPoints * 3 / 4) {
    std::vector<Point> half;
    for (std::size_t i = 0; i < coarser.points_.size(); i += 2) half.push_back(coarser.points_[i]);
    coarser.points_ = std::move(half);
  }
  *this = std::move(coarser);
}

std::string ContourPicture::svg(std::size_t horizontal, std::size_t vertical) const {
  std::array<double, 2> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const Point& p : points_) {
    const std::array<double, 2> at = {p.at[horizontal], p.at[vertical]};
    for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
  }
  const double width = high[0] - low[0], height = high[1] - low[1];
  if (points_.size() < 2 || std::max(width, height) <= 0) return "";
  const double scale = std::min((kWidth - 40) / std::max(width, 1e-9), (kContourHeight - 40) / std::max(height, 1e-9));
  const double picture_height = height * scale + 40;
  const auto place = [&](const Point& p) {
    return fmt::format("{:.1f} {:.1f}", 20 + (p.at[horizontal] - low[0]) * scale,
                       picture_height - 20 - (p.at[vertical] - low[1]) * scale);
  };
  std::array<std::string, kCividis.size()> paths;
  std::size_t last = paths.size();
  std::string from = place(points_[0]);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const std::size_t now = colour((points_[i - 1].speed + points_[i].speed) / 2);
    std::string to = place(points_[i]);
    if (to == from) continue;
    if (now != last) paths[now] += "M" + from;
    paths[now] += "L" + to;
    last = now;
    from = std::move(to);
  }
  const std::string axes = {"XYZ"[horizontal], "XYZ"[vertical]};
  std::string svg =
      fmt::format("<svg class='contour' viewBox='0 0 {:.0f} {:.1f}' role='img' aria-label='contour in {}'>", kWidth,
                  picture_height, axes);
  for (std::size_t bin = 0; bin < paths.size(); ++bin) {
    if (!paths[bin].empty()) svg += fmt::format("<path stroke='{}' d='{}'/>", kCividis[bin], paths[bin]);
  }
  svg += fmt::format("</svg>\n<p class='legend'>{} view, {:.4g} mm × {:.4g} mm; speed 0 ", axes, width, height);
  for (const char* colour : kCividis) svg += fmt::format("<i style='background:{}'></i>", colour);
  return svg + fmt::format(" {:.4g} mm/s</p>\n", fastest_);
}

}  // namespace toolpace
