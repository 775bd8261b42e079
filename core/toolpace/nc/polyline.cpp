#include "toolpace/nc/polyline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "toolpace/base/axis_unit.h"
#include "toolpace/nc/diagnostic_log.h"
#include "toolpace/nc/move_writer.h"

namespace toolpace::nc {
namespace {

constexpr std::size_t kLongestRow = 65536;
constexpr int kFeedColumn = static_cast<int>(kAxisCount);
constexpr int kUnknownColumn = -1;

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\"") - begin + 1);
}

int column_of(std::string_view title) {
  std::string key(trim(title));
  for (char& c : key) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  constexpr std::array<std::string_view, kAxisCount> kTitles = {"x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"};
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (key == kTitles[i] || (is_rotary(i) && key == kTitles[i].substr(0, 1))) return static_cast<int>(i);
  }
  return key == "feed_mm_min" ? kFeedColumn : kUnknownColumn;
}

class PolylineReader {
 public:
  PolylineReader(const std::string& name, const ReadOptions& options, Reading& reading)
      : name_(name), reading_(reading), log_(reading.diagnostics, options.strict) {}

  bool run(std::string_view text, const Monitor& monitor);

 private:
  using Row = std::array<double, kAxisCount + 1>;

  bool read_header(std::string_view line);
  bool read_row(std::string_view line, Row& row, bool& has_feed);
  void append(const Row& row, bool has_feed);
  void fault(std::size_t column, const char* code, std::string what, std::string remedy,
             Severity severity = Severity::error) {
    if (log_.add({code, std::move(what), std::move(remedy), column, severity}, name_, number_, line_)) stopped_ = true;
  }

  const std::string& name_;
  Reading& reading_;
  DiagnosticLog log_;
  std::vector<int> columns_;
  char separator_ = ',';
  std::size_t number_ = 0;
  std::string_view line_;
  bool has_start_ = false;
  bool feed_column_ = false;
  bool stopped_ = false;  ///< nothing is appended after an error
};

bool PolylineReader::read_header(std::string_view line) {
  if (line.find(',') == std::string_view::npos)
    separator_ = line.find(';') != std::string_view::npos    ? ';'
                 : line.find('\t') != std::string_view::npos ? '\t'
                                                             : ',';
  std::array<bool, kAxisCount + 1> seen{};
  std::vector<std::pair<std::size_t, std::string_view>> unknown;
  bool any_axis = false;
  const char* const begin = line.data();
  for (std::string_view rest = line;;) {
    const std::size_t length = std::min(rest.find(separator_), rest.size());
    const std::string_view title = rest.substr(0, length);
    const int column = column_of(title);
    const auto place = static_cast<std::size_t>(title.data() - begin) + 1;
    if (column == kUnknownColumn) {
      unknown.push_back({place, title});
    } else if (std::exchange(seen[static_cast<std::size_t>(column)], true)) {
      fault(place, "column-twice", fmt::format("column \"{}\" stands twice", trim(title)), "remove one of them");
      return false;
    }
    any_axis = any_axis || (column >= 0 && column < kFeedColumn);
    columns_.push_back(column);
    if (length == rest.size()) break;
    rest.remove_prefix(length + 1);
  }
  feed_column_ = seen[static_cast<std::size_t>(kFeedColumn)];
  if (any_axis) {
    for (const auto& [place, title] : unknown) {
      fault(place, "column-unknown", fmt::format("column \"{}\" is not used", trim(title).substr(0, 40)),
            "columns are x_mm y_mm z_mm a_deg b_deg c_deg feed_mm_min", Severity::warning);
    }
    return true;
  }
  fault(1, "header-missing", "the first line names no axis", "begin with a header such as x_mm,y_mm,z_mm,feed_mm_min");
  return false;
}

bool PolylineReader::read_row(std::string_view line, Row& row, bool& has_feed) {
  row.fill(0.0);
  has_feed = false;
  const char* p = line.data();
  const char* const end = p + line.size();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    while (p != end && (*p == ' ' || *p == '\t') && *p != separator_) ++p;
    if (p != end && *p == '+') ++p;
    const auto place = static_cast<std::size_t>(p - line.data()) + 1;
    const int column = columns_[i];
    if (column == kUnknownColumn) {
      while (p != end && *p != separator_) ++p;
    } else if (p != end && *p != separator_ && *p != '\r') {
      double value = 0.0;
      const auto result = std::from_chars(p, end, value);
      if (result.ec == std::errc::result_out_of_range && std::fabs(value) <= 1.0) {
        // from_chars leaves the value alone; tiny numbers read as zero, huge ones are refused below
        value = std::string_view(p, static_cast<std::size_t>(result.ptr - p)).find("e-") == std::string_view::npos
                    ? HUGE_VAL
                    : 0.0;
      }
      if (result.ec == std::errc::invalid_argument || !std::isfinite(value)) {
        fault(place, result.ec == std::errc::invalid_argument ? "number-expected" : "number-not-finite",
              result.ec == std::errc::invalid_argument ? "this is no number" : "the number is not finite or too large",
              "correct the value");
        return false;
      }
      row[static_cast<std::size_t>(column)] = value;
      has_feed = has_feed || column == kFeedColumn;
      p = result.ptr;
      while (p != end && (*p == ' ' || *p == '\t' || *p == '\r') && *p != separator_) ++p;
      if (p != end && *p != separator_) {
        fault(static_cast<std::size_t>(p - line.data()) + 1, "number-expected", "this is no number",
              "correct the value");
        return false;
      }
    } else if (column != kFeedColumn) {
      fault(place, "value-missing", "a value is missing in this row",
            fmt::format("rows need {} values", columns_.size()));
      return false;
    }
    if (p != end && *p == separator_) ++p;
  }
  while (p != end && (*p == ' ' || *p == '\r' || *p == '\t')) ++p;
  if (p == end) return true;
  fault(static_cast<std::size_t>(p - line.data()) + 1, "too-many-values", "this row has more values than the header",
        "remove them");
  return false;
}

void PolylineReader::append(const Row& row, bool has_feed) {
  Moves& moves = reading_.moves;
  AxisVector point;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    point[static_cast<Eigen::Index>(i)] = row[i] * axis_unit(i).size;
  }
  if (!(point.cwiseAbs().maxCoeff() <= kFarthest)) {
    fault(1, "coordinate-too-large", fmt::format("a point more than {:g} mm away", kFarthest), "check the numbers");
    return;
  }
  if (!has_start_) {
    has_start_ = true;
    moves.start = point;
    return;
  }
  double feed = std::numeric_limits<double>::infinity();
  if (feed_column_) {
    const double programmed = row[static_cast<std::size_t>(kFeedColumn)];
    if (!has_feed || !(programmed > 0.0)) {
      fault(1, "no-feed", has_feed ? fmt::format("a feed of {:g} mm/min", programmed) : "a row without a feed",
            "feeds are above 0");
      return;
    }
    const AxisVector& before = moves.begin_of(moves.size());
    const bool linear = before.head<3>() != point.head<3>();
    const bool angular = before.tail<3>() != point.tail<3>();
    feed = programmed * kPerMinute * (angular && !linear ? kRadiansPerDegree : 1.0);
  }
  moves.kind.push_back(MoveKind::feed);
  moves.line.push_back(static_cast<std::uint32_t>(number_));
  moves.file.push_back(0);
  moves.mode.push_back(0);
  moves.detail.push_back(kNoDetail);
  moves.end.push_back(point);
  moves.feed.push_back(feed);
}

bool PolylineReader::run(std::string_view text, const Monitor& monitor) {
  const double size = static_cast<double>(std::max<std::size_t>(text.size(), 1));
  const char* const begin = text.data();
  bool has_header = false;
  while (!text.empty() && !log_.is_full()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    line_ = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (++number_ % kReportEvery == 0) {
      if (monitor.is_cancelled()) return false;
      monitor.report(static_cast<double>(line_.data() - begin) / size);
    }
    if (line_.size() > kLongestRow) {
      fault(0, "line-too-long", fmt::format("a line of {} bytes", line_.size()),
            fmt::format("rows may have {} bytes", kLongestRow));
      continue;
    }
    const std::string_view content = trim(line_);
    if (content.empty() || content.front() == '#') continue;
    if (!has_header) {
      has_header = true;
      if (!read_header(line_)) break;
      continue;
    }
    Row row;
    bool has_feed = false;
    if (read_row(line_, row, has_feed) && !stopped_) append(row, has_feed);
  }
  if (has_header && !has_start_ && !log_.has_errors())
    fault(0, "no-points", "there is no point behind the header", "add rows");
  log_.finish(name_);
  reading_.refused = log_.has_errors();
  return true;
}

}  // namespace

namespace {

/// All rows are about the tip: what they tell first is told by the axes where they begin. @return false (with a fault)
bool tell_about_tip(const ReadOptions& options, const std::string& name, Reading& reading) {
  const Kinematics& kinematics = options.kinematics;
  const auto refuse = [&](const char* code, const char* what, const char* remedy) {
    reading.diagnostics.push_back({Severity::error, code, what, remedy, {name, 1, 1}, {}});
    reading.refused = true;
    return false;
  };
  if (kinematics.chain.is_identity()) {
    return refuse("kinematics-missing", "--tcp is about the tool's tip, but how the rotary axes carry it is not known",
                  "name a machine file with [kinematics] by --machine");
  }
  if (kinematics.chain.swings_tool() && !kinematics.tells_tool_length) {
    return refuse("tool-length-missing", "--tcp needs the length of the tool, which a head swings",
                  "add tool_mm to [kinematics]");
  }
  Moves& moves = reading.moves;
  moves.chains.push_back(kinematics.chain);
  moves.modes.front().chain = 1;
  moves.start = told_about({}, kinematics.chain, moves.start);
  return true;
}

}  // namespace

bool read_polyline(std::string_view text, const std::string& name, const ReadOptions& options, const Monitor& monitor,
                   Reading& reading) {
  if (!PolylineReader(name, options, reading).run(text, monitor)) return false;
  if (options.about_tip) tell_about_tip(options, name, reading);
  return true;
}

}  // namespace toolpace::nc
