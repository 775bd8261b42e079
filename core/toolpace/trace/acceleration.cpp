#include "toolpace/trace/acceleration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "toolpace/servo/find_modes.h"
#include "toolpace/trace/trace.h"

namespace toolpace {
namespace {

constexpr double kGravity = 9806.65;  // [mm/s²]
constexpr double kEven = 0.05;        // of a step, that rows may be off
constexpr double kMostScatter = 0.5;  // of a step

struct AccelerationUnit {
  std::string_view name;
  double size;  // [mm/s²]
};
constexpr AccelerationUnit kAccelerationUnits[] = {
    {"g", kGravity},  {"mg", kGravity * 1e-3}, {"mm/s2", 1.0},   {"mm/s^2", 1.0}, {"mm/s²", 1.0},
    {"m/s2", 1000.0}, {"m/s^2", 1000.0},       {"m/s²", 1000.0}, {"mm_s2", 1.0},  {"m_s2", 1000.0}};

const AccelerationUnit* unit_named(std::string_view name) {
  const auto at = std::find_if(std::begin(kAccelerationUnits), std::end(kAccelerationUnits),
                               [&](const AccelerationUnit& u) { return u.name == name; });
  return at == std::end(kAccelerationUnits) ? nullptr : &*at;
}

Error columns_error(ErrorKind kind, std::string message, const std::string& file) {
  return {kind,
          "accelerometer-columns",
          std::move(message),
          "say which is which: --columns t=1,x=2,y=3,z=4, with a unit in brackets: x=2[g]",
          {file, kind == ErrorKind::input ? std::size_t{1} : 0, 0},
          {}};
}

/// The unit in brackets, or behind the last underscore, taken off a name; empty where there is none.
std::string take_unit(std::string& name) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
    const std::size_t at = name.find(open);
    if (at == std::string::npos || name.empty() || name.back() != close) continue;
    const std::string unit = name.substr(at + 1, name.size() - at - 2);
    name.erase(name.find_last_not_of(' ', at > 0 ? at - 1 : 0) + 1);
    return unit;
  }
  for (const std::string_view behind : {"_mm_s2", "_m_s2", "_mg", "_g"}) {
    if (!name.ends_with(behind)) continue;
    name.erase(name.size() - behind.size());
    return std::string(behind.substr(1));
  }
  return {};
}

/// x, accel_x, ax, X-Acc, "Accelerometer Z" … -> which axis.
std::optional<std::size_t> axis_in(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::size_t acc = name.find("acc");
  if (acc != std::string::npos) {
    std::size_t end = acc;
    while (end < name.size() && std::isalpha(static_cast<unsigned char>(name[end])) &&
           !(end > acc + 2 && end + 1 == name.size()))
      ++end;
    name = name.substr(0, acc) + name.substr(end);
  } else if (name.size() == 2 && name[0] == 'a') {
    name.erase(0, 1);
  }
  std::erase_if(name, [](unsigned char c) { return !std::isalnum(c); });
  const std::size_t axis = name.size() == 1 ? std::string_view("xyz").find(name[0]) : std::string_view::npos;
  if (axis == std::string_view::npos) return std::nullopt;
  return axis;
}

/// Which columns are what, for TraceFile, and the units of the accelerations.
struct AccelerationColumns {
  std::vector<TraceMapping> mapping;
  AccelerationRecord record;
  std::array<double, 3> size = {1, 1, 1};

  void take_axis(std::size_t axis, const std::string& column, const std::string& name, const AccelerationUnit* unit) {
    record.column[axis] = name;
    record.unit[axis] = unit ? std::string(unit->name) : "";
    if (unit) size[axis] = unit->size;
    mapping.push_back({TraceRole::actual, axis, column + "[mm]"});
  }
};

Result<AccelerationColumns> told_columns(const AccelerationOptions& options, const std::string& file) {
  auto told = parse_trace_mapping(options.columns);
  if (!told) return tl::unexpected(told.error());
  AccelerationColumns columns;
  for (TraceMapping& m : *told) {
    if (m.role == TraceRole::time) {
      columns.mapping.push_back(std::move(m));
      continue;
    }
    std::string name = m.column;
    const std::string unit = take_unit(name);
    if (m.axis > 2 || (!unit.empty() && !unit_named(unit))) {
      return tl::unexpected(columns_error(
          ErrorKind::usage,
          m.axis > 2 ? "an accelerometer feels X, Y and Z" : "there is no acceleration '" + unit + "'", file));
    }
    columns.take_axis(m.axis, name, name, unit_named(unit));
  }
  return columns;
}

Result<AccelerationColumns> guessed_columns(const std::filesystem::path& file, const Monitor& monitor) {
  const auto preview = preview_trace(file, monitor);
  if (!preview) return tl::unexpected(preview.error());
  AccelerationColumns columns;
  const auto& all = preview->columns;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    if (all[i].role == TraceRole::time) {
      columns.mapping.push_back(
          {TraceRole::time, 0, number + "[" + (all[i].unit_name.empty() ? "s" : all[i].unit_name) + "]"});
      continue;
    }
    std::string name = all[i].name;
    const std::string unit = take_unit(name);
    const bool has_no_names = all[i].name == number;
    const auto axis = has_no_names && all[i].role != TraceRole::ignored && all[i].axis < 3 ? std::optional(all[i].axis)
                                                                                           : axis_in(name);
    if (axis && columns.record.column[*axis].empty()) columns.take_axis(*axis, number, all[i].name, unit_named(unit));
  }
  if (columns.record.column != std::array<std::string, 3>{}) return columns;
  return tl::unexpected(columns_error(ErrorKind::input, "no column is known to be an acceleration", file.string()));
}

Error rows_error(const char* code, std::string message, const char* remedy, const Trace& trace, std::size_t row) {
  return {ErrorKind::input, code, std::move(message), remedy, {trace.name, trace.first_line + row, 1}, {}};
}

/// The rows at even steps from the first to the last.
Result<void> make_even(const Trace& trace, AccelerationRecord& record, const std::array<double, 3>& size) {
  const auto& time = trace.rows.time;
  if (time.size() < kFewestAccelerations) {
    return tl::unexpected(rows_error("accelerometer-short",
                                     fmt::format("{} rows are too few to find a mode in", time.size()),
                                     "record some seconds at the rate of the accelerometer", trace, time.size()));
  }
  const double period = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  bool is_even = true;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double off = time[i] - time.front() - static_cast<double>(i) * period;
    const double step = i > 0 ? time[i] - time[i - 1] : period;
    is_even &= std::abs(off) <= kEven * period;
    if (std::abs(off) <= 10 * period && std::abs(step - period) <= kMostScatter * period) continue;
    return tl::unexpected(
        rows_error("accelerometer-uneven",
                   fmt::format("a step of {:.6g} s, where rows follow each other every {:.6g} s", step, period),
                   "record at an even rate, or cut the recording to where it is even", trace, i));
  }
  record.period = period;
  for (std::size_t axis = 0; axis < record.axis.size(); ++axis) {
    const auto& from = trace.rows.actual[axis];
    if (from.empty()) continue;
    auto& to = record.axis[axis];
    if (is_even) {  // and saturated values stay what they are
      for (const double a : from) to.push_back(size[axis] * a);
      continue;
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double t = time.front() + static_cast<double>(i) * period;
      while (k + 2 < time.size() && time[k + 1] < t) ++k;
      const double share = std::clamp((t - time[k]) / (time[k + 1] - time[k]), 0.0, 1.0);
      to.push_back(size[axis] * (from[k] + share * (from[k + 1] - from[k])));
    }
  }
  return {};
}

}  // namespace

std::size_t AccelerationRecord::rows() const {
  std::size_t most = 0;
  for (const auto& a : axis) most = std::max(most, a.size());
  return most;
}

Result<AccelerationRecord> read_acceleration(const std::filesystem::path& file, const AccelerationOptions& options,
                                             const Monitor& monitor) {
  auto columns = options.columns.empty() ? guessed_columns(file, monitor) : told_columns(options, file.string());
  if (!columns) return tl::unexpected(columns.error());
  TraceOptions reading;
  reading.columns = columns->mapping;
  reading.step = options.step;
  const auto trace = read_trace(file, reading, monitor);
  if (!trace) return tl::unexpected(trace.error());
  AccelerationRecord record = std::move(columns->record);
  record.name = file.string();
  if (auto even = make_even(*trace, record, columns->size); !even) return tl::unexpected(even.error());
  return record;
}

}  // namespace toolpace
