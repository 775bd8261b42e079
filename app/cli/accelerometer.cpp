#include "accelerometer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "servo_json.h"
#include "toolpace/base/numbers.h"

namespace toolpace::cli {
namespace {

constexpr double kSameMode = 0.05;  // of a frequency
constexpr double kSilent = 0.01;    // of the loudest axis: what it is made of is the others' shaking

double rounded_mode(double value, const char* format) {
  return parse_number(fmt::format(fmt::runtime(format), value)).value_or(value);
}

double rms(const std::vector<double>& s) {
  double sum = 0, squares = 0;
  for (const double x : s) sum += x, squares += x * x;
  const auto count = static_cast<double>(s.size());
  return std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
}

Diagnostic warning(const char* code, std::string message, std::string remedy, const std::string& file) {
  return {Severity::warning, code, std::move(message), std::move(remedy), {file, 0, 0}, {}};
}

/// As the machine file takes them.
std::vector<AxisMode> kept_modes(const FoundModes& found, const ServoAxis& servo, char axis, const std::string& file,
                                 Diagnostics& warnings) {
  std::vector<AxisMode> kept;
  for (const FoundMode& m : found.modes) {
    if (std::abs(m.mode.frequency - servo.resonance) < kSameMode * m.mode.frequency) {
      warnings.push_back(
          warning("accelerometer-known",
                  fmt::format("the mode of {} at {:.4g} Hz is its resonance_hz already", axis, m.mode.frequency),
                  "take resonance_hz out of [servo.X] to have it as a mode", file));
      continue;
    }
    kept.push_back({rounded_mode(m.mode.frequency, "{:.5g}"), rounded_mode(m.mode.damping, "{:.3g}"),
                    rounded_mode(m.mode.share, "{:.3g}")});
  }
  return kept;
}

}  // namespace

Result<ShakenAxes> find_shaken_axes(const AccelerationRecord& record, const ServoMachine& servo) {
  ShakenAxes shaken;
  double loudest = 0;
  for (const auto& samples : record.axis) loudest = std::max(loudest, samples.empty() ? 0.0 : rms(samples));
  bool any = false;
  for (std::size_t axis = 0; axis < record.axis.size(); ++axis) {
    const auto& samples = record.axis[axis];
    if (samples.empty() || rms(samples) < kSilent * loudest) continue;
    auto found = find_modes(samples, record.period);
    if (!found) {
      Error error = found.error();
      error.message += fmt::format(" along {}", kAxisNames[axis]);
      error.where.file = record.name;
      return tl::unexpected(std::move(error));
    }
    if (found->modes.empty()) continue;
    any = true;
    auto kept = kept_modes(*found, servo[axis], kAxisNames[axis], record.name, shaken.warnings);
    shaken.axis[axis] = ShakenAxis{std::move(*found), std::move(kept)};
  }
  if (any) return shaken;
  return tl::unexpected(Error{ErrorKind::input,
                              "accelerometer-no-peak",
                              "no mode stands out of what the accelerometer felt",
                              "shake or tap the axis harder, and record some seconds of it",
                              {record.name, 0, 0},
                              {}});
}

Json accelerometer_json(const AccelerationRecord& record, const ShakenAxes& shaken, const std::string& output) {
  Json axes = Json::object(), warnings = Json::array();
  for (std::size_t axis = 0; axis < record.axis.size(); ++axis) {
    if (record.axis[axis].empty()) continue;
    Json modes = Json::array(), tones = Json::array();
    if (shaken.axis[axis]) {
      for (const FoundMode& m : shaken.axis[axis]->found.modes) {
        Json mode = mode_json(m.mode);
        mode["frequency_error_hz"] = m.frequency_error;
        mode["damping_error"] = m.damping_error;
        mode["half_power_damping"] = m.half_power_damping;
        mode["rise_db"] = 10 * std::log10(m.rise);
        modes.push_back(std::move(mode));
      }
      for (const double tone : shaken.axis[axis]->found.tones) tones.push_back(tone);
    }
    axes[std::string(1, kAxisNames[axis])] = {{"column", record.column[axis]},
                                              {"unit", record.unit[axis]},
                                              {"rms_mm_s2", rms(record.axis[axis])},
                                              {"modes", std::move(modes)},
                                              {"tones_hz", std::move(tones)}};
  }
  for (const Diagnostic& d : shaken.warnings) warnings.push_back({{"code", d.code}, {"message", d.message}});
  return {{"accelerometer", record.name}, {"output", output.empty() ? Json(nullptr) : Json(output)},
          {"rows", record.rows()},        {"period_ms", record.period * 1e3},
          {"axes", std::move(axes)},      {"warnings", std::move(warnings)}};
}

void print_accelerometer(const AccelerationRecord& record, const ShakenAxes& shaken) {
  fmt::print("{}\n  recorded     {} rows every {:.6g} ms\n", record.name, record.rows(), record.period * 1e3);
  for (std::size_t axis = 0; axis < record.axis.size(); ++axis) {
    if (record.axis[axis].empty()) continue;
    fmt::print("  axis {}       {}\n", kAxisNames[axis], shaken.axis[axis] ? "" : "no mode stands out");
    if (!shaken.axis[axis]) continue;
    for (const FoundMode& m : shaken.axis[axis]->found.modes) {
      fmt::print("    mode       {:.5g} ± {:.2g} Hz, damping {:.3g} ± {:.1g}, share {:.3g}\n", m.mode.frequency,
                 m.frequency_error, m.mode.damping, m.damping_error, m.mode.share);
    }
    for (const double tone : shaken.axis[axis]->found.tones)
      fmt::print("    tone       {:.5g} Hz: too narrow for a mode\n", tone);
  }
}

}  // namespace toolpace::cli
