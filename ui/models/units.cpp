#include "models/units.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "toolpace/base/axes.h"

namespace toolpace::ui {
namespace {

constexpr double kMmPerInch = 25.4, kSecondsPerMinute = 60;

QString grouped(QString digits) {
  const qsizetype point = digits.indexOf('.');
  const qsizetype end = point < 0 ? digits.size() : point;
  const qsizetype begin = digits.startsWith('-') ? 1 : 0;
  if (end - begin <= 4) return digits;
  for (qsizetype at = end - 3; at > begin; at -= 3) digits.insert(at, QChar(0x2009));
  return digits;
}

}  // namespace

DisplayUnit display_unit(Quantity quantity, Units unit) {
  const double factor = unit.inch ? 1 / kMmPerInch : 1.0;
  const QString name = unit.inch ? "in" : "mm";
  const double a_time = unit.per_minute ? kSecondsPerMinute : 1.0;
  const QString time = unit.per_minute ? "/min" : "/s";
  switch (quantity) {
    case Quantity::length: return {factor, name};
    case Quantity::speed: return {factor * a_time, name + time};
    case Quantity::acceleration: return {factor, name + "/s²"};
    case Quantity::jerk: return {factor, name + "/s³"};
    case Quantity::angle: return {1 / kRadiansPerDegree, "°"};
    case Quantity::angular_speed: return {a_time / kRadiansPerDegree, "°" + time};
    case Quantity::angular_acceleration: return {1 / kRadiansPerDegree, "°/s²"};
    case Quantity::angular_jerk: return {1 / kRadiansPerDegree, "°/s³"};
    case Quantity::time: break;
  }
  return {1.0, "s"};
}

DisplayUnit error_unit(Units unit) { return unit.inch ? DisplayUnit{1e3 / kMmPerInch, "mil"} : DisplayUnit{1e3, "µm"}; }

int decimals_of(Quantity quantity, int metric, Units units) {
  const bool turns = rotary(quantity) == quantity;  // and time, which has no other unit
  const bool is_speed = quantity == Quantity::speed || quantity == Quantity::angular_speed;
  return std::max(metric + (units.inch && !turns ? 1 : 0) - (units.per_minute && is_speed ? 1 : 0), 0);
}

Quantity rotary(Quantity quantity) {
  switch (quantity) {
    case Quantity::length: return Quantity::angle;
    case Quantity::speed: return Quantity::angular_speed;
    case Quantity::acceleration: return Quantity::angular_acceleration;
    case Quantity::jerk: return Quantity::angular_jerk;
    default: return quantity;
  }
}

QString number_text(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size >= 1e9 || size < 1e-6) return QString::number(value, 'g', std::min(digits, 4));
  const int whole = static_cast<int>(std::floor(std::log10(size))) + 1;
  QString text = QString::number(value, 'f', std::clamp(digits - std::max(whole, 0), 0, 9));
  if (text.contains('.')) {
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith('.')) text.chop(1);
  }
  return grouped(text == "-0" ? "0" : text);
}

QString error_text(double core_value, const DisplayUnit& unit, int digits) {
  constexpr double kNothing = 1e-6;
  const double shown = core_value * unit.factor;
  return number_text(std::abs(shown) < kNothing ? 0.0 : shown, digits);
}

QString value_text(double core_value, Quantity quantity, Units unit, int digits) {
  const auto shown = display_unit(quantity, unit);
  return number_text(core_value * shown.factor, digits) + " " + shown.text;
}

QString duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  if (seconds < 60) return QString::number(seconds, 'f', 3) + " s";
  const auto whole = static_cast<long long>(seconds);
  if (seconds < 3600) {
    return QString("%1 min %2 s")
        .arg(whole / 60)
        .arg(seconds - static_cast<double>(whole / 60 * 60), 4, 'f', 1, QLatin1Char('0'));
  }
  return QString("%1 h %2 min").arg(whole / 3600).arg(whole / 60 % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace toolpace::ui
