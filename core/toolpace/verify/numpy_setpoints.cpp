/// .npy and .npz.

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/base/axis_unit.h"
#include "toolpace/verify/numpy_array.h"
#include "toolpace/verify/origin_text.h"
#include "toolpace/verify/setpoint_readers.h"
#include "toolpace/verify/zip_reader.h"

namespace toolpace::detail {
namespace {

constexpr std::size_t kBlockRows = 1024;         // a block stays in the second-level cache
constexpr std::uint64_t kLongestMeta = 1 << 20;  // [bytes]

/// Why it is no table of float64, or nothing.
std::string table_fault(const NumpyArray& array) {
  if (array.type != "<f8") return "its numbers are of type \"" + array.type + "\", not little-endian float64 (\"<f8\")";
  if (array.shape.size() != 2)
    return "it has " + std::to_string(array.shape.size()) + " dimensions, not rows and columns";
  return array.size_fault(array.shape[0], array.shape[1]);
}

class NumpySetpoints final : public SetpointFile {
 public:
  explicit NumpySetpoints(std::string name) : name_(std::move(name)) {}

  Result<void> take(NumpyArray table) {
    if (const std::string fault = table_fault(table); !fault.empty()) return tl::unexpected(shape_error(fault, name_));
    width_ = static_cast<std::size_t>(table.shape[1]);
    rows_ = table.shape[0];
    // The columns of .csv without "line": with or without rotary axes, with or without derivatives of each axis.
    const bool linear = width_ == 7 || width_ == 7 + 9;
    const bool rotary = width_ == 10 || width_ == 10 + 18;
    if (!linear && !rotary) {
      return tl::unexpected(shape_error("7 or 10 columns are due, or 16 or 28 with axis derivatives", name_));
    }
    axes_ = rotary ? kAxisCount : 3;
    columns_.axis_derivatives = width_ > 10;
    std::fill_n(columns_.axis.begin(), axes_, true);
    columns_.time = columns_.profile = true;
    table_ = std::move(table);
    return {};
  }

  Result<void> take_lines(NumpyArray lines) {
    if (lines.type != "<i8" || lines.shape.size() != 1 || lines.shape[0] != rows_ ||
        !lines.size_fault(rows_, 1).empty()) {
      return tl::unexpected(shape_error("\"line\" is not one int64 a row", name_));
    }
    lines_ = std::move(lines);
    columns_.line = true;
    return {};
  }

  void take_origin(SetpointOrigin origin) { origin_ = std::move(origin); }

  Result<std::size_t> read(SetpointRows& rows, std::size_t limit) override {
    if (at_ == 0) {
      if (auto begun = begin(); !begun) return tl::unexpected(std::move(begun.error()));
    }
    std::size_t taken = 0;
    while (taken < limit && at_ < rows_) {
      const auto n = static_cast<std::size_t>(std::min<std::uint64_t>({limit - taken, kBlockRows, rows_ - at_}));
      if (auto block = read_block(rows, n); !block) return tl::unexpected(std::move(block.error()));
      at_ += n;
      taken += n;
    }
    if (at_ == rows_) {
      if (auto whole = finish(); !whole) return tl::unexpected(std::move(whole.error()));
    }
    rows.count += taken;
    return taken;
  }

  void rewind() override { at_ = 0; }
  double progress() const override { return rows_ == 0 ? 1.0 : static_cast<double>(at_) / static_cast<double>(rows_); }

 private:
  Result<void> begin() {
    if (auto done = table_.seek_values(); !done) return done;
    return columns_.line ? lines_.seek_values() : Result<void>{};
  }

  Result<void> finish() {
    if (auto done = table_.stream->finish(); !done) return done;
    return columns_.line ? lines_.stream->finish() : Result<void>{};
  }

  Result<void> read_block(SetpointRows& rows, std::size_t n) {
    block_.resize(n * width_);
    auto read = table_.stream->read(reinterpret_cast<char*>(block_.data()), block_.size() * sizeof(double));
    if (!read) return read;
    std::size_t column = 0;
    bool finite = append(rows.time, column++, n, 1.0);
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      finite &= append(rows.position[axis], column++, n, axis_unit(axis).size);
    }
    for (auto* values : {&rows.speed, &rows.acceleration, &rows.jerk}) finite &= append(*values, column++, n, 1.0);
    for (std::size_t order = 0; columns_.axis_derivatives && order < kDerivatives; ++order) {
      for (std::size_t axis = 0; axis < axes_; ++axis) {
        finite &= append(rows.derivative[order][axis], column++, n, axis_unit(axis).size);
      }
    }
    if (!finite) {
      const auto bad = std::find_if(block_.begin(), block_.end(), [](double v) { return !std::isfinite(v); });
      const std::uint64_t row = at_ + static_cast<std::uint64_t>(bad - block_.begin()) / width_;
      return tl::unexpected(broken("a number is not finite", row));
    }
    return columns_.line ? read_lines(rows, n) : Result<void>{};
  }

  /// @return whether all are finite
  bool append(std::vector<double>& out, std::size_t column, std::size_t n, double unit) const {
    const std::size_t old = out.size();
    out.resize(old + n);
    double check = 0.0;  // stays 0 while all are finite
    const double* in = block_.data() + column;
    for (std::size_t k = 0; k < n; ++k, in += width_) {
      out[old + k] = *in * unit;
      check += *in * 0.0;
    }
    return check == 0.0;
  }

  Result<void> read_lines(SetpointRows& rows, std::size_t n) {
    line_block_.resize(n);
    auto read = lines_.stream->read(reinterpret_cast<char*>(line_block_.data()), n * sizeof(std::int64_t));
    if (!read) return read;
    for (std::size_t k = 0; k < n; ++k) {
      const std::int64_t line = line_block_[k];
      if (line < 0 || line > std::numeric_limits<std::uint32_t>::max()) {
        return tl::unexpected(broken("a line number is out of range", at_ + k));
      }
      rows.line.push_back(static_cast<std::uint32_t>(line));
    }
    return {};
  }

  Error broken(const char* what, std::uint64_t row) const {
    return setpoints_error("setpoints-broken", what, {name_, static_cast<std::size_t>(row) + 1, 0});
  }

  std::string name_;
  NumpyArray table_, lines_;
  std::uint64_t rows_ = 0, at_ = 0;
  std::size_t width_ = 0, axes_ = 3;
  std::vector<double> block_;
  std::vector<std::int64_t> line_block_;
};

/// Reads an entry for its checksum alone.
Result<void> check_entry(ByteStream& entry) {
  std::string piece(kBlockRows, '\0');
  for (std::uint64_t left = entry.size(); left > 0;) {
    const auto n = static_cast<std::size_t>(std::min<std::uint64_t>(left, piece.size()));
    if (auto read = entry.read(piece.data(), n); !read) return read;
    left -= n;
  }
  return entry.finish();
}

/// The text in an array of one text; none where it is no such array. Letters that are not ASCII become '?'.
std::optional<std::string> text_of(std::unique_ptr<ByteStream> entry, const std::string& name) {
  auto array = open_array(std::move(entry), name);
  if (!array || !array->type.starts_with("<U") || !array->shape.empty() || array->bytes > kLongestMeta) return {};
  std::string points(static_cast<std::size_t>(array->bytes), '\0');
  if (!array->seek_values() || !array->stream->read(points.data(), points.size())) return {};
  std::string text;
  for (std::size_t k = 0; k + 3 < points.size(); k += 4) {
    const bool is_ascii = points[k + 1] == 0 && points[k + 2] == 0 && points[k + 3] == 0 && points[k] > 0;
    text += is_ascii ? points[k] : '?';
  }
  return text;
}

}  // namespace

Result<std::unique_ptr<SetpointFile>> open_npy(InputFile file, const std::string& name) {
  auto array = open_array(stream_of_file(std::move(file)), name);
  if (!array) return tl::unexpected(std::move(array.error()));
  auto numpy = std::make_unique<NumpySetpoints>(name);
  if (auto fine = numpy->take(std::move(*array)); !fine) return tl::unexpected(std::move(fine.error()));
  return numpy;
}

Result<std::unique_ptr<SetpointFile>> open_npz(InputFile file, const std::string& name) {
  const auto archive = ZipReader::open(std::move(file));
  if (!archive) return tl::unexpected(archive.error());
  auto numpy = std::make_unique<NumpySetpoints>(name);
  for (const char* key : {"setpoints", "line", "meta"}) {
    const bool is_table = key == std::string_view("setpoints"), is_lines = key == std::string_view("line");
    auto entry = (*archive)->entry(key + std::string(".npy"));
    if (!entry) return tl::unexpected(std::move(entry.error()));
    if (*entry == nullptr) {
      if (is_table) return tl::unexpected(shape_error("there is no array \"setpoints\" in it", name));
      continue;
    }
    Result<void> fine;
    if (is_table || is_lines) {
      auto array = open_array(std::move(*entry), name);
      if (!array) return tl::unexpected(std::move(array.error()));
      fine = is_table ? numpy->take(std::move(*array)) : numpy->take_lines(std::move(*array));
    } else {
      fine = check_entry(**entry);
      if (fine) {
        (*entry)->rewind();
        if (auto text = text_of(std::move(*entry), name)) numpy->take_origin(origin_of_text(*text));
      }
    }
    if (!fine) return tl::unexpected(std::move(fine.error()));
  }
  return numpy;
}

}  // namespace toolpace::detail
