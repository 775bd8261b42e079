/// .csv, semicolon and .halstream.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "toolpace/base/axis_unit.h"
#include "toolpace/verify/line_reader.h"
#include "toolpace/verify/setpoint_readers.h"

namespace toolpace::detail {
namespace {

enum class Meaning : std::uint8_t { ignored, time, position, speed, acceleration, jerk, line, derivative };

struct Column {
  Meaning meaning = Meaning::ignored;
  std::size_t axis = 0;
  std::size_t order = 0;  ///< of a derivative: 0 = speed

  bool operator==(const Column&) const = default;
};

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestNumber = 64;  // no double that reads back needs more

/// v_x_mm_s, a_x_mm_s2, …, j_c_deg_s3.
std::optional<Column> derivative_of(std::string_view name) {
  constexpr std::string_view kOrders = "vaj", kAxes = "xyzabc";
  if (name.size() < 5 || name[1] != '_' || name[3] != '_') return {};
  const std::size_t order = kOrders.find(name[0]), axis = kAxes.find(name[2]);
  if (order >= kDerivatives || axis >= kAxisCount || name.substr(4) != axis_unit(axis).key[order + 1]) return {};
  return Column{Meaning::derivative, axis, order};
}

Column meaning_of(std::string_view name) {
  constexpr std::array<std::string_view, kAxisCount> kAxes = {"x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"};
  const auto axis = std::find(kAxes.begin(), kAxes.end(), name);
  if (axis != kAxes.end()) return {Meaning::position, static_cast<std::size_t>(axis - kAxes.begin()), 0};
  if (name == "t_s") return {Meaning::time};
  if (name == "v_mm_s") return {Meaning::speed};
  if (name == "a_mm_s2") return {Meaning::acceleration};
  if (name == "j_mm_s3") return {Meaning::jerk};
  if (name == "line") return {Meaning::line};
  return derivative_of(name).value_or(Column{});
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin, end - begin + 1);
}

class TextSetpoints final : public SetpointFile {
 public:
  TextSetpoints(InputFile file, std::string name) : lines_(std::move(file)), name_(std::move(name)) {}

  Result<void> read_header() {
    auto first = lines_.next();
    if (!first) return tl::unexpected(std::move(first.error()));
    std::string_view header = first->value_or("");
    if (header.starts_with(kByteOrderMark)) header.remove_prefix(kByteOrderMark.size());
    separator_ = header.find(';') != std::string_view::npos ? ';' : ',';
    std::vector<std::string_view> names;
    for (std::size_t at = 0; at <= header.size();) {
      const std::size_t end = std::min(header.find(separator_, at), header.size());
      names.push_back(trimmed(header.substr(at, end - at)));
      add(meaning_of(names.back()));
      at = end + 1;
    }
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (order_[i].meaning == Meaning::derivative && !columns_.axis[order_[i].axis]) order_[i] = {};
      if (order_[i].meaning == Meaning::ignored) columns_.ignored.emplace_back(names[i]);
    }
    return finish_header();
  }

  /// No header: as many positions as the first line has numbers.
  Result<void> assume_positions() {
    separator_ = ' ';
    auto first = lines_.next();
    if (!first) return tl::unexpected(std::move(first.error()));
    const std::string_view line = first->value_or("");
    const auto count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ' ')) + 1;
    for (std::size_t axis = 0; axis < std::min(count, kAxisCount); ++axis) add({Meaning::position, axis, 0});
    lines_.seek(0, 0);
    return finish_header();
  }

  Result<std::size_t> read(SetpointRows& rows, std::size_t limit) override {
    std::size_t taken = 0;
    for (; taken < limit; ++taken) {
      auto line = lines_.next();
      if (!line) return tl::unexpected(std::move(line.error()));
      if (*line && (*line)->empty()) {
        const auto more = pass_empty_lines();
        if (!more) return tl::unexpected(more.error());
        if (!*more) break;
        return tl::unexpected(number_error(0, **more));
      }
      if (!*line) break;
      if (auto row = read_row(rows, **line); !row) return tl::unexpected(std::move(row.error()));
    }
    rows.count += taken;
    return taken;
  }

  void rewind() override { lines_.seek(body_, body_line_); }

  double progress() const override {
    return static_cast<double>(lines_.at()) / static_cast<double>(lines_.file().size());
  }

 private:
  void add(Column column) {
    order_.push_back(column);
    switch (column.meaning) {
      case Meaning::time: columns_.time = true; break;
      case Meaning::position: columns_.axis[column.axis] = true; break;
      case Meaning::jerk: columns_.profile = true; break;
      case Meaning::line: columns_.line = true; break;
      case Meaning::derivative: columns_.axis_derivatives = true; break;
      default: break;
    }
  }

  Result<void> finish_header() {
    const auto has = [this](Meaning m) {
      return std::any_of(order_.begin(), order_.end(), [m](const Column& c) { return c.meaning == m; });
    };
    columns_.profile = has(Meaning::speed) && has(Meaning::acceleration) && has(Meaning::jerk);
    for (auto& column : order_) {
      const bool profile = column.meaning >= Meaning::speed && column.meaning <= Meaning::jerk;
      if (profile && !columns_.profile) column.meaning = Meaning::ignored;
    }
    for (std::size_t i = 0; i < order_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (order_[i].meaning != Meaning::ignored && order_[i] == order_[k])
          return tl::unexpected(header_error("a column stands there twice"));
      }
    }
    if (!has(Meaning::position))
      return tl::unexpected(header_error("there is no column x_mm, y_mm, z_mm, a_deg, b_deg or c_deg"));
    body_ = lines_.at();
    body_line_ = lines_.line();
    return {};
  }

  Error header_error(std::string what) const {
    return setpoints_error("setpoints-header", std::move(what), {name_, 1, 1},
                           "the header is t_s,x_mm,y_mm,z_mm[,a_deg,b_deg,c_deg],v_mm_s,a_mm_s2,j_mm_s3,line");
  }

  /// Empty lines are fine at the end of the file alone.
  /// @return the number of the first one, if lines that are not empty stand behind it
  Result<std::optional<std::size_t>> pass_empty_lines() {
    const std::size_t first = lines_.line();
    for (;;) {
      const auto line = lines_.next();
      if (!line) return tl::unexpected(line.error());
      if (!*line) return std::nullopt;
      if (!(*line)->empty()) return first;
    }
  }

  Result<void> read_row(SetpointRows& rows, std::string_view line) {
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t c = 0; c < order_.size(); ++c) {
      if (c > 0) {
        if (at == end || *at != separator_) return tl::unexpected(number_error(line, at));
        ++at;
      }
      while (separator_ != ' ' && at != end && *at == ' ') ++at;
      const char* const begin = at;
      const auto value = take_number(at, end);
      if (!value || !put(rows, order_[c], *value)) return tl::unexpected(number_error(line, begin));
    }
    if (at != end) return tl::unexpected(number_error(line, at));
    return {};
  }

  std::optional<double> take_number(const char*& at, const char* end) const {
    double value = 0.0;
    if (separator_ != ';') {
      const auto [stop, error] = std::from_chars(at, end, value);
      if (error != std::errc{} || !std::isfinite(value)) return {};
      at = stop;
      return value;
    }
    std::array<char, kLongestNumber> copy;
    const auto length =
        std::min<std::size_t>(static_cast<std::size_t>(std::find(at, end, separator_) - at), copy.size());
    std::replace_copy(at, at + length, copy.begin(), ',', '.');
    const auto [stop, error] = std::from_chars(copy.data(), copy.data() + length, value);
    if (error != std::errc{} || !std::isfinite(value)) return {};
    at += stop - copy.data();
    return value;
  }

  /// @return false for a line that is no whole number from 0 on
  static bool put(SetpointRows& rows, const Column& column, double value) {
    switch (column.meaning) {
      case Meaning::time: rows.time.push_back(value); break;
      case Meaning::position: rows.position[column.axis].push_back(value * axis_unit(column.axis).size); break;
      case Meaning::speed: rows.speed.push_back(value); break;
      case Meaning::acceleration: rows.acceleration.push_back(value); break;
      case Meaning::jerk: rows.jerk.push_back(value); break;
      case Meaning::line:
        if (!(value >= 0 && value < 4294967296.0) || value != std::floor(value)) return false;
        rows.line.push_back(static_cast<std::uint32_t>(value));
        break;
      case Meaning::derivative:
        rows.derivative[column.order][column.axis].push_back(value * axis_unit(column.axis).size);
        break;
      case Meaning::ignored: break;
    }
    return true;
  }

  Error number_error(std::string_view line, const char* at) const {
    return number_error(static_cast<std::size_t>(at - line.data()), lines_.line());
  }
  Error number_error(std::size_t before, std::size_t line) const {
    return setpoints_error("setpoints-broken", "there is no fitting number where one is due", {name_, line, before + 1},
                           std::to_string(order_.size()) + " numbers are due in each line");
  }

  LineReader lines_;
  std::string name_;
  char separator_ = ',';
  std::vector<Column> order_;
  std::uint64_t body_ = 0;     ///< place of the first row
  std::size_t body_line_ = 0;  ///< lines before it
};

}  // namespace

namespace {

Result<std::unique_ptr<SetpointFile>> opened(std::unique_ptr<TextSetpoints> text, const Result<void>& header) {
  if (!header) return tl::unexpected(header.error());
  return text;
}

}  // namespace

Result<std::unique_ptr<SetpointFile>> open_text(InputFile file, const std::string& name) {
  auto text = std::make_unique<TextSetpoints>(std::move(file), name);
  const auto header = text->read_header();
  return opened(std::move(text), header);
}

Result<std::unique_ptr<SetpointFile>> open_halstream(InputFile file, const std::string& name) {
  auto text = std::make_unique<TextSetpoints>(std::move(file), name);
  const auto header = text->assume_positions();
  return opened(std::move(text), header);
}

}  // namespace toolpace::detail
