/// Text formats: comma, semicolon, and LinuxCNC's halstreamer.

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "toolpace/io/setpoint_table.h"
#include "toolpace/io/writers.h"

namespace toolpace::detail {
namespace {

constexpr std::size_t kNumberBytes = 32;  // the longest double takes 24, the longest line number 10
/// The text of a column's last value: columns often stand still (Z in a plane, jerk in a cruise).
struct LastText {
  double value = 0.0;
  std::size_t length = 1;
  char text[kNumberBytes] = {'0'};
};

struct TextStyle {
  char separator;
  bool decimal_comma = false;
  bool positions_only = false;  ///< without a header
};

class TextWriter final : public SetpointWriter {
 public:
  TextWriter(OutputFile file, SetpointTable table, const TextStyle& style)
      : file_(std::move(file)),
        table_(std::move(table)),
        positions_only_(style.positions_only),
        separator_(style.separator),
        comma_(style.decimal_comma) {}

  Result<void> write(const Setpoints& chunk) override {
    if (auto loaded = table_.load(chunk); !loaded) return loaded;
    if (buffer_.empty()) {
      choose_columns();
      if (auto done = write_header(); !done) return done;
    }
    const std::size_t row_bytes = (columns_.size() + 1) * kNumberBytes;
    char* out = buffer_.data();
    char* const brim = buffer_.data() + buffer_.size() - row_bytes;
    for (std::size_t k = 0; k < table_.rows(); ++k) {
      out = put_row(out, k);
      if (out > brim) {
        if (auto done = send(out); !done) return done;
        out = buffer_.data();
      }
    }
    return send(out);
  }

  Result<void> finish() override { return file_.commit(); }

 private:
  void choose_columns() {
    for (std::size_t c = 0; c < table_.names().size(); ++c) {
      const std::string& name = table_.names()[c];
      const bool position = name.ends_with("_mm") || name.ends_with("_deg");
      if (position || !positions_only_) columns_.push_back(c);
    }
    last_.assign(columns_.size(), {});
    buffer_.resize(kBufferBytes);
  }

  Result<void> write_header() {
    if (positions_only_) return {};
    std::string header;
    for (const std::size_t c : columns_) header += table_.names()[c] + separator_;
    return file_.write(header + "line\n");
  }

  char* put_row(char* out, std::size_t k) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      out = put_number(out, last_[i], table_.columns()[columns_[i]][k]);
      *out++ = separator_;
    }
    if (positions_only_) {
      out[-1] = '\n';
      return out;
    }
    out = fmt::format_to(out, FMT_COMPILE("{}"), table_.lines()[k]);
    *out++ = '\n';
    return out;
  }

  char* put_number(char* out, LastText& last, double value) const {
    value += 0.0;  // -0 is shown as 0
    if (value != last.value) {
      last.value = value;
      char* const end = fmt::format_to(last.text, FMT_COMPILE("{}"), value);
      if (comma_) std::replace(last.text, end, '.', ',');
      last.length = static_cast<std::size_t>(end - last.text);
    }
    std::memcpy(out, last.text, kNumberBytes);  // whole, since a fixed size is faster than the right one
    return out + last.length;
  }

  Result<void> send(const char* end) {
    return file_.write({buffer_.data(), static_cast<std::size_t>(end - buffer_.data())});
  }

  OutputFile file_;
  SetpointTable table_;
  bool positions_only_;
  char separator_;
  bool comma_;
  std::vector<std::size_t> columns_;
  std::vector<LastText> last_;
  std::string buffer_;
};

}  // namespace

MadeWriter make_csv_writer(OutputFile file, const SetpointFileOptions& options) {
  return std::make_unique<TextWriter>(std::move(file), SetpointTable(options.axis_derivatives, options.tip_of),
                                      TextStyle{','});
}

MadeWriter make_semicolon_writer(OutputFile file, const SetpointFileOptions& options) {
  return std::make_unique<TextWriter>(std::move(file), SetpointTable(options.axis_derivatives, options.tip_of),
                                      TextStyle{';', options.decimal_comma});
}

MadeWriter make_halstream_writer(OutputFile file, const SetpointFileOptions&) {
  return std::make_unique<TextWriter>(std::move(file), SetpointTable(false),
                                      TextStyle{.separator = ' ', .positions_only = true});
}

}  // namespace toolpace::detail
