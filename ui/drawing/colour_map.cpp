#include "drawing/colour_map.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace toolpace::ui {
namespace {

constexpr std::array<QRgb, 18> kCividis = {0xff00204c, 0xff002a66, 0xff00346e, 0xff273f6c, 0xff3c4a6b, 0xff4c556b,
                                           0xff5b5f6d, 0xff686a70, 0xff757575, 0xff838178, 0xff928c78, 0xffa19876,
                                           0xffb0a572, 0xffc0b16d, 0xffd1bf66, 0xffe1cc5c, 0xfff3db4f, 0xffffe945};
constexpr std::array<QRgb, 10> kViridis = {0xff440154, 0xff482878, 0xff3e4989, 0xff31688e, 0xff26828e,
                                           0xff1f9e89, 0xff35b779, 0xff6ece58, 0xffb5de2b, 0xfffde725};
constexpr std::array<QRgb, 15> kTurbo = {0xff30123b, 0xff4145ab, 0xff4675ed, 0xff39a2fc, 0xff1bcfd4,
                                         0xff24eca6, 0xff61fc6c, 0xffa4fc3b, 0xffd1e834, 0xfff3c63a,
                                         0xfffe9b2d, 0xfff36315, 0xffd93806, 0xffb11901, 0xff7a0402};

std::span<const QRgb> stops(ColourMap map) {
  switch (map) {
    case ColourMap::viridis: return kViridis;
    case ColourMap::turbo: return kTurbo;
    case ColourMap::cividis: break;
  }
  return kCividis;
}

QRgb mix(QRgb a, QRgb b, double share) {
  const auto channel = [share](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
  return qRgb(channel(qRed(a), qRed(b)), channel(qGreen(a), qGreen(b)), channel(qBlue(a), qBlue(b)));
}

double linear(int channel) {
  const double c = channel / 255.0;
  return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Turbo is dark at both ends and bright in the middle, so its colours are moved by what each one lacks.
QRgb with_contrast(QRgb colour, QRgb ground, QRgb towards) {
  for (int step = 0; step <= 20; ++step) {
    const QRgb moved = mix(colour, towards, 0.05 * step);
    if (contrast(moved, ground) >= 2.05) return moved;
  }
  return towards;
}

constexpr std::array kNames = {"cividis", "viridis", "turbo"};

}  // namespace

QString colour_map_name(ColourMap map) { return kNames[static_cast<std::size_t>(map)]; }

std::optional<ColourMap> colour_map_named(const QString& name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == QLatin1String(kNames[i])) return static_cast<ColourMap>(i);
  }
  return std::nullopt;
}

QRgb map_colour(ColourMap map, double fraction) {
  const auto table = stops(map);
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), table.size() - 2);
  return mix(table[lower], table[lower + 1], place - static_cast<double>(lower));
}

ColourTable colour_table(ColourMap map, Ground ground) {
  constexpr QRgb kWhite = 0xffffffff, kDarkSurface = 0xff1c2026, kBlack = 0xff000000, kHaze = 0xff5a96e6;
  ColourTable table;
  for (std::size_t level = 0; level < table.size(); ++level) {
    const double fraction = static_cast<double>(level) / 255.0;
    const QRgb colour = map_colour(map, fraction);
    if (map == ColourMap::turbo) {
      table[level] =
          ground == Ground::light ? with_contrast(colour, kWhite, kBlack) : with_contrast(colour, kDarkSurface, kWhite);
    } else if (ground == Ground::light) {
      table[level] = mix(colour, kBlack, 0.28 * fraction * fraction);
    } else {
      table[level] = mix(colour, kHaze, 0.55 * (1 - fraction));
    }
  }
  return table;
}

ColourTable diverging_table(Ground ground) {
  struct Arms {
    QRgb below, half_below, zero, half_above, above;
  };
  constexpr Arms kOnLight = {0xff08306b, 0xff2f7fc4, 0xffa9aeb5, 0xffd9772b, 0xff7f2704};
  constexpr Arms kOnDark = {0xffc6e2ff, 0xff5aa2f0, 0xff686d74, 0xfff0913a, 0xffffe3c2};
  const Arms& arms = ground == Ground::light ? kOnLight : kOnDark;
  const std::array<QRgb, 5> stops = {arms.below, arms.half_below, arms.zero, arms.half_above, arms.above};
  ColourTable table;
  for (std::size_t level = 0; level < table.size(); ++level) {
    // Both levels in the middle are zero: a value of 0 is rounded to the upper one.
    const double from_zero = std::max(std::abs(static_cast<double>(level) - 127.5) - 0.5, 0.0) / 127.0;
    const double place = 2 + (level < 128 ? -2 : 2) * from_zero;
    const auto lower = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    table[level] = mix(stops[lower], stops[lower + 1], place - static_cast<double>(lower));
  }
  return table;
}

double luminance(QRgb colour) {
  return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

double contrast(QRgb a, QRgb b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace toolpace::ui
