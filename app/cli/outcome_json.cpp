#include "outcome_json.h"

#include <algorithm>
#include <string>

#include "toolpace/base/axis_unit.h"
#include "toolpace/law/law_table.h"
#include "toolpace/limits/travel.h"
#include "toolpace/machine/setup_keys.h"

namespace toolpace::cli {
namespace {

template <class T>
std::string name_of(const std::vector<Named<T>>& names, T value) {
  for (const auto& n : names) {
    if (n.value == value) return std::string(n.name);
  }
  return "";
}

std::string corner_name(const CornerOptions& corner) {
  return corner.step ? "step" : name_of(corner_names(), corner.rule);
}

/// null where there is no such motion
void add_peaks(Json& j, const Peaks& peaks, const std::string& unit) {
  const auto add = [&](const char* name, double value, const char* per) {
    j[name + unit + per] = peaks.speed > 0 ? Json(value) : Json(nullptr);
  };
  add("max_speed_", peaks.speed, "_s");
  add("max_acceleration_", peaks.acceleration, "_s2");
  add("max_jerk_", peaks.jerk, "_s3");
}

/// Where axes leave their travel, and by how much.
Json travel_json(const Outcome& outcome) {
  const Moves& moves = outcome.job->program->moves;
  Json list = Json::array();
  for (const TravelExcess& e : find_travel_excess(*outcome.path, outcome.job->machine)) {
    const AxisUnit& unit = axis_unit(e.axis);
    list.push_back({{"axis", std::string(1, kAxisNames[e.axis])},
                    {"end", e.is_upper ? "upper" : "lower"},
                    {std::string("excess_") + unit.key[0], e.excess / unit.size},
                    {"line", moves.line[e.row]},
                    {"worst_line", moves.line[e.worst_row]}});
  }
  return list;
}

}  // namespace

Json diagnostics_json(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics) {
    list.push_back({{"line", d.where.line}, {"column", d.where.column}, {"code", d.code}, {"message", d.message}});
  }
  return list;
}

Json outcome_json(const Outcome& outcome) {
  const Summary& s = outcome.summary;
  const PlanOptions& o = outcome.job->options;
  Json j;
  j["program"] = outcome.job->program_name;
  j["dialect"] = std::string(dialect_name(outcome.job->program->dialect));
  j["dialect_reasons"] = outcome.job->program->dialect_reasons;
  j["law"] = std::string(law_row(o.law).id);
  j["lookahead_blocks"] = o.lookahead;
  j["ramps"] = name_of(ramps_names(), o.ramps);
  j["corner"] = corner_name(o.corner);
  j["ran"] = {{"law", std::string(law_row(outcome.ran.law).id)},
              {"ramps", name_of(ramps_names(), outcome.ran.ramps)},
              {"lookahead_blocks", outcome.ran.lookahead},
              {"corner", corner_name(outcome.ran.corner)}};
  j["blocks"] = s.blocks;
  j["path_length_mm"] = s.path_length;
  j["cycle_time_s"] = s.cycle_time;
  j["feed_time_s"] = s.feed_time;
  j["rapid_time_s"] = s.rapid_time;
  j["dwell_time_s"] = s.dwell_time;
  add_peaks(j, s.peaks, "mm");
  add_peaks(j, s.rotary_peaks, "deg");
  j["period_ms"] = outcome.job->machine.period * 1e3;
  j["time_by_limit_s"] = Json::object();
  for (std::size_t i = 0; i < s.time_by_cause.size(); ++i) {
    if (s.time_by_cause[i] > 0)
      j["time_by_limit_s"][std::string(cause_name(static_cast<Cause>(i)))] = s.time_by_cause[i];
  }
  j["corners"] = {{"blended", s.blends.corners},
                  {"stopped", s.blends.stops},
                  {"merged_segments", s.blends.merged},
                  {"max_deviation_mm", std::max(s.blends.deviation, s.tube_deviation)}};
  j["smooth"] = {{"windows", s.tube_windows}, {"fallbacks", s.tube_fallbacks}};
  j["bound_s"] = nullptr;
  Diagnostics warnings = outcome.job->program->diagnostics;
  warnings.insert(warnings.end(), outcome.warnings.begin(), outcome.warnings.end());
  j["warnings"] = diagnostics_json(warnings);
  j["travel_left"] = travel_json(outcome);
  return j;
}

Json axes_json(const AxisPeakMeter& meter) {
  Json axes = Json::object();
  const auto peaks = meter.peaks();
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    if (!meter.has_moved(k)) continue;
    const AxisUnit& unit = axis_unit(k);
    axes[std::string(1, kAxisNames[k])] = {
        {std::string("max_speed_") + unit.key[1], peaks[k].speed / unit.size},
        {std::string("max_acceleration_") + unit.key[2], peaks[k].acceleration / unit.size},
        {std::string("max_jerk_") + unit.key[3], peaks[k].jerk / unit.size}};
  }
  return axes;
}

}  // namespace toolpace::cli
