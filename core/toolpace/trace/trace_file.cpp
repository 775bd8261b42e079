#include "toolpace/trace/trace_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "toolpace/trace/trace_layout.h"
#include "toolpace/verify/line_reader.h"

namespace toolpace {
namespace {

using detail::TraceLayout;

constexpr double kSlowestUnnamedStep = 0.05;  // [s] a longer one, of a time without a unit, is in ms

Error trace_error(const char* code, std::string message, std::string remedy, Location where) {
  return {ErrorKind::input, code, std::move(message), std::move(remedy), std::move(where), {}};
}

bool rises_evenly(const TraceLayout& layout, std::size_t column, double& step) {
  step = layout.begin[1][column] - layout.begin[0][column];
  for (std::size_t i = 1; i < layout.begin.size(); ++i) {
    const double here = layout.begin[i][column] - layout.begin[i - 1][column];
    if (!(here > 0) || std::abs(here - step) > 0.01 * step) return false;
  }
  return true;
}

/// Columns without names: a sample number or a time where the first one rises evenly, and the axes in their order.
std::vector<TraceColumn> columns_in_order(const TraceLayout& layout) {
  const std::size_t count = layout.begin[0].size();
  std::vector<TraceColumn> columns(count);
  std::size_t first = 0;
  double step = 0;
  if (count > 1 && rises_evenly(layout, 0, step)) {
    columns[0].role =
        step == 1 && layout.begin[0][0] == std::floor(layout.begin[0][0]) ? TraceRole::sample : TraceRole::time;
    first = 1;
  }
  for (std::size_t i = first; i < std::min(count, first + kAxisCount); ++i) {
    columns[i] = {"", TraceRole::position, i - first, i - first < 3 ? 1.0 : kRadiansPerDegree, ""};
  }
  for (std::size_t i = 0; i < count; ++i) columns[i].name = std::to_string(i + 1);
  return columns;
}

std::vector<TraceColumn> guess_columns(const TraceLayout& layout) {
  if (layout.names.empty()) return columns_in_order(layout);
  std::vector<TraceColumn> columns;
  for (std::size_t i = 0; i < layout.names.size(); ++i) {
    columns.push_back(guess_column(layout.names[i], i < layout.units.size() ? layout.units[i] : ""));
    if (layout.is_twincat && layout.names[i] == "Name") {
      columns.back().role = TraceRole::time;
      columns.back().unit = 1e-3;
      columns.back().unit_name = "ms";
    }
  }
  return columns;
}

/// A time without a unit is in ms where a second a row would be too slow to record anything.
void guess_time_unit(std::vector<TraceColumn>& columns, const TraceLayout& layout) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    TraceColumn& c = columns[i];
    if (c.role != TraceRole::time || !c.unit_name.empty()) continue;
    const bool is_slow = layout.begin[1][i] - layout.begin[0][i] >= kSlowestUnnamedStep;
    c.unit_name = is_slow ? "ms" : "s";
    c.unit = is_slow ? 1e-3 : 1.0;
  }
}

}  // namespace

struct TraceFile::Inside {
  LineReader lines;
  std::string name;
  TraceLayout layout;
  std::vector<TraceColumn> columns;
  std::size_t needed = 0;  ///< columns up to the last one that means something
  std::optional<double> step;
  bool has_time = false;
  std::size_t row = 0;
  std::uint64_t size = 1;

  Result<void> set_time(const std::optional<double>& told) {
    step = told;
    bool has_sample = false;
    for (const TraceColumn& c : columns) {
      has_time |= c.role == TraceRole::time;
      has_sample |= c.role == TraceRole::sample;
    }
    if (has_time || told) return {};
    return tl::unexpected(trace_error(
        "trace-time",
        has_sample ? "samples are numbered, but nothing tells the time between them"
                   : "no column is known to be the time",
        "name it with --columns t=NAME, or give the time from row to row with --trace-period-ms", {name, 0, 0}));
  }

  Result<void> read_row(std::string_view line, TraceRows& rows) {
    std::size_t at = 0;
    for (std::size_t c = 0; c < needed; ++c) {
      if (c > 0 && layout.separator != ' ') {
        at = line.find(layout.separator, at);
        if (at == std::string_view::npos) return tl::unexpected(broken("the row ends too early", line.size()));
        ++at;
      }
      while (at < line.size() && (line[at] == ' ' || line[at] == '"' || (line[at] == '\t' && layout.separator != '\t')))
        ++at;
      if (columns[c].role == TraceRole::ignored) {
        if (layout.separator == ' ') at = std::min(line.find_first_of(" \t", at), line.size());
        continue;
      }
      double value = 0;
      const std::size_t length = detail::take_number(line.substr(at), layout.separator, value);
      if (length == 0) return tl::unexpected(broken("there is no number where one is due", at));
      if (!std::isfinite(value)) {
        return tl::unexpected(trace_error("trace-number", "a value is no finite number",
                                          "cut the trace to where all of its channels were recorded",
                                          {name, lines.line(), at + 1}));
      }
      at += length;
      if (!ends_number(line, at)) return tl::unexpected(broken("there is no number where one is due", at - length));
      put(columns[c], value, rows);
    }
    ++row;
    return {};
  }

  bool ends_number(std::string_view line, std::size_t at) const {
    return at == line.size() || line[at] == ' ' || line[at] == '\t' || line[at] == '"' || line[at] == layout.separator;
  }

  void put(const TraceColumn& column, double value, TraceRows& rows) const {
    switch (column.role) {
      case TraceRole::time: rows.time.push_back(value * column.unit); break;
      case TraceRole::sample: rows.time.push_back(value * step.value_or(0)); break;
      case TraceRole::actual: rows.actual[column.axis].push_back(value * column.unit); break;
      case TraceRole::commanded: rows.commanded[column.axis].push_back(value * column.unit); break;
      case TraceRole::position:
      case TraceRole::ignored: break;
    }
  }

  Error broken(std::string message, std::size_t at) const {
    return trace_error("trace-broken", std::move(message),
                       "each row needs a number in every column; record all channels at one rate",
                       {name, lines.line(), at + 1});
  }

  /// True where nothing but blank lines, or TwinCAT's mark, follows.
  Result<bool> ends(std::string_view line) {
    if (line == "EOF") return true;
    if (line.find_first_not_of(" \t") != std::string_view::npos) return false;
    const std::size_t blank = lines.line();
    for (;;) {
      auto next = lines.next();
      if (!next) return tl::unexpected(next.error());
      if (!*next || **next == "EOF") return true;
      if ((*next)->find_first_not_of(" \t") == std::string_view::npos) continue;
      return tl::unexpected(
          trace_error("trace-gap", "rows go on after an empty line", "cut the trace there", {name, blank, 1}));
    }
  }
};

TraceFile::TraceFile(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
TraceFile::TraceFile(TraceFile&&) noexcept = default;
TraceFile& TraceFile::operator=(TraceFile&&) noexcept = default;
TraceFile::~TraceFile() = default;

Result<TraceFile> TraceFile::open(const std::filesystem::path& file, const TraceOptions& options,
                                  const Monitor& monitor) {
  auto input = InputFile::open(file, monitor);
  if (!input) return tl::unexpected(input.error());
  const std::uint64_t size = std::max<std::uint64_t>(1, input->size());
  const std::string name = file.string();
  LineReader lines(std::move(*input));
  auto layout = detail::find_layout(lines, name);
  if (!layout) return tl::unexpected(layout.error());
  auto inside = std::make_unique<Inside>(Inside{std::move(lines), name, std::move(*layout), {}, 0, {}, false, 0, size});
  inside->columns = guess_columns(inside->layout);
  if (auto done = settle_columns(inside->columns, options.columns, name); !done) return tl::unexpected(done.error());
  guess_time_unit(inside->columns, inside->layout);
  for (std::size_t i = 0; i < inside->columns.size(); ++i) {
    if (inside->columns[i].role != TraceRole::ignored) inside->needed = i + 1;
  }
  if (auto done = inside->set_time(options.step); !done) return tl::unexpected(done.error());
  inside->lines.seek(inside->layout.body, inside->layout.body_line);
  return TraceFile(std::move(inside));
}

const std::vector<TraceColumn>& TraceFile::columns() const { return inside_->columns; }

bool TraceFile::has(TraceRole role, std::size_t axis) const {
  return std::any_of(inside_->columns.begin(), inside_->columns.end(),
                     [&](const TraceColumn& c) { return c.role == role && c.axis == axis; });
}

std::size_t TraceFile::line_of(std::size_t row) const { return inside_->layout.body_line + row + 1; }

Result<std::size_t> TraceFile::read(TraceRows& rows, std::size_t limit) {
  Inside& in = *inside_;
  std::size_t taken = 0;
  const bool counts = std::none_of(in.columns.begin(), in.columns.end(), [](const TraceColumn& c) {
    return c.role == TraceRole::time || c.role == TraceRole::sample;
  });
  for (; taken < limit; ++taken) {
    auto line = in.lines.next();
    if (!line) return tl::unexpected(line.error());
    if (!*line) break;
    std::string_view text = **line;
    if (in.row == 0 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (text.empty() || text[0] == ' ' || text[0] == '\t' || text[0] == 'E') {
      auto end = in.ends(text);
      if (!end) return tl::unexpected(end.error());
      if (*end) break;
    }
    if (text == "overrun") {
      return tl::unexpected(trace_error("trace-gap", "the sampler lost samples here",
                                        "record again with a larger buffer (depth of the sampler)",
                                        {in.name, in.lines.line(), 1}));
    }
    if (counts) rows.time.push_back(static_cast<double>(in.row) * in.step.value_or(0));
    if (auto done = in.read_row(text, rows); !done) return tl::unexpected(done.error());
  }
  return taken;
}

double TraceFile::progress() const {
  return std::min(1.0, static_cast<double>(inside_->lines.at()) / static_cast<double>(inside_->size));
}

Result<TracePreview> preview_trace(const std::filesystem::path& file, const Monitor& monitor) {
  auto input = InputFile::open(file, monitor);
  if (!input) return tl::unexpected(input.error());
  const std::string name = file.string();
  LineReader lines(std::move(*input));
  auto layout = detail::find_layout(lines, name);
  if (!layout) return tl::unexpected(layout.error());
  TracePreview preview{guess_columns(*layout), {}};
  // What cannot be settled yet is for a person to say.
  if (auto settled = preview.columns; settle_columns(settled, {}, name)) preview.columns = std::move(settled);
  guess_time_unit(preview.columns, *layout);
  preview.rows = std::move(layout->begin);
  return preview;
}

}  // namespace toolpace
