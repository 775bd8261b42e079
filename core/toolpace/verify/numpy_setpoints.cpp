/// .npy and .npz.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "toolpace/verify/setpoint_formats.h"

namespace toolpace::verify_detail {
namespace {

constexpr std::uint64_t kRowsBetweenReleases = 1 << 18;

struct Array {
  std::string_view type;
  std::vector<std::uint64_t> shape;
  std::string_view data;
};

template <class Integer>
Integer little_endian(std::string_view bytes, std::size_t at) {
  Integer value{};
  if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::string_view between(std::string_view text, std::string_view after, char open, char close) {
  const std::size_t key = text.find(after);
  const std::size_t begin = key == std::string_view::npos ? key : text.find(open, key + after.size());
  const std::size_t end = begin == std::string_view::npos ? begin : text.find(close, begin + 1);
  return end == std::string_view::npos ? std::string_view{} : text.substr(begin + 1, end - begin - 1);
}

/// The array, or what is wrong with it.
/// @source NumPy Enhancement Proposal 1, versions 1.0 to 3.0
tl::expected<Array, std::string> parse_array(std::string_view bytes) {
  const auto fault = [](std::string what) { return tl::unexpected(std::move(what)); };
  if (!bytes.starts_with("\x93NUMPY") || bytes.size() < 12) return fault("there is no whole header of an array");
  const bool first_version = bytes[6] == 1;
  const std::size_t begin = first_version ? 10 : 12;
  const std::size_t length =
      first_version ? little_endian<std::uint16_t>(bytes, 8) : little_endian<std::uint32_t>(bytes, 8);
  if (begin + length > bytes.size()) return fault("there is no whole header of an array");
  const std::string_view header = bytes.substr(begin, length);
  if (header.find("'fortran_order': True") != std::string_view::npos) return fault("the array is in Fortran order");
  if (header.find("'fortran_order': False") == std::string_view::npos) return fault("the header says no order");
  if (header.find("'descr': [") != std::string_view::npos) return fault("it is an array of records");
  Array array{between(header, "'descr':", '\'', '\''), {}, bytes.substr(begin + length)};
  std::string_view shape = between(header, "'shape':", '(', ')');
  while (!shape.empty()) {
    std::uint64_t extent = 0;
    const auto [stop, error] = std::from_chars(shape.data(), shape.data() + shape.size(), extent);
    if (error != std::errc{}) return fault("the header says no shape");
    array.shape.push_back(extent);
    shape.remove_prefix(static_cast<std::size_t>(stop - shape.data()));
    shape.remove_prefix(std::min(shape.find_first_not_of(", "), shape.size()));
  }
  return array;
}

/// Whether data holds rows · columns values of 8 bytes.
bool holds(const Array& array, std::uint64_t rows, std::uint64_t columns) {
  const std::uint64_t values = array.data.size() / sizeof(double);
  return columns == 0 ? rows == 0 : rows <= values / columns;
}

/// Why it is no table of float64, or nothing.
std::string table_fault(const Array& array) {
  if (array.type != "<f8") {
    return "its numbers are of type \"" + std::string(array.type) + "\", not little-endian float64 (\"<f8\")";
  }
  if (array.shape.size() != 2)
    return "it has " + std::to_string(array.shape.size()) + " dimensions, not rows and columns";
  if (holds(array, array.shape[0], array.shape[1])) return "";
  return "it is cut short: " + std::to_string(array.shape[0]) + " rows of " + std::to_string(array.shape[1]) +
         " columns are due, and there are " +
         std::to_string(array.data.size() / sizeof(double) / std::max<std::uint64_t>(1, array.shape[1]));
}

class NumpySetpoints final : public SetpointFile {
 public:
  NumpySetpoints(MappedFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

  std::string_view bytes() const { return file_.bytes(); }

  Result<void> take(const tl::expected<Array, std::string>& table) {
    const std::string fault = table ? table_fault(*table) : table.error();
    if (!fault.empty()) return tl::unexpected(shape_error(fault));
    width_ = table->shape[1];
    rows_ = table->shape[0];
    data_ = table->data;
    // The columns of .csv without "line": with or without rotary axes, with or without derivatives of each axis.
    const bool linear = width_ == 7 || width_ == 7 + 9;
    const bool rotary = width_ == 10 || width_ == 10 + 18;
    if (!linear && !rotary)
      return tl::unexpected(shape_error("7 or 10 columns are due, or 16 or 28 with axis derivatives"));
    axes_ = rotary ? kAxisCount : 3;
    columns_.axis_derivatives = width_ > 10;
    std::fill_n(columns_.axis.begin(), axes_, true);
    columns_.time = columns_.profile = true;
    return {};
  }

  Result<void> take_lines(const tl::expected<Array, std::string>& lines) {
    if (!lines || lines->type != "<i8" || lines->shape.size() != 1 || lines->shape[0] != rows_ ||
        !holds(*lines, rows_, 1)) {
      return tl::unexpected(shape_error("\"line\" is not one int64 a row"));
    }
    lines_ = lines->data;
    columns_.line = true;
    return {};
  }

  Result<std::size_t> read(SetpointRows& rows, std::size_t limit) override {
    const std::size_t n = static_cast<std::size_t>(std::min<std::uint64_t>(limit, rows_ - at_));
    if (n == 0) return n;
    std::size_t column = 0;
    bool finite = append(rows.time, column++, n, 1.0);
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      finite &= append(rows.position[axis], column++, n, is_rotary(axis) ? kRadiansPerDegree : 1.0);
    }
    for (auto* values : {&rows.speed, &rows.acceleration, &rows.jerk}) finite &= append(*values, column++, n, 1.0);
    for (std::size_t order = 0; columns_.axis_derivatives && order < kDerivatives; ++order) {
      for (std::size_t axis = 0; axis < axes_; ++axis) {
        finite &= append(rows.derivative[order][axis], column++, n, is_rotary(axis) ? kRadiansPerDegree : 1.0);
      }
    }
    if (!finite) {
      return tl::unexpected(
          setpoints_error("setpoints-broken", "a number is not finite", {name_, first_bad_row(n) + 1, 0}));
    }
    if (const auto bad = append_lines(rows, n)) {
      return tl::unexpected(setpoints_error("setpoints-broken", "a line number is out of range", {name_, *bad + 1, 0}));
    }
    at_ += n;
    if (at_ >= next_release_) {
      const char* const begin = bytes().data();
      file_.release_before(static_cast<std::size_t>(data_.data() - begin) + at_ * width_ * sizeof(double));
      // The lines lie behind the table: what is between is not in memory yet and costs nothing to give up.
      if (columns_.line)
        file_.release_before(static_cast<std::size_t>(lines_.data() - begin) + at_ * sizeof(std::int64_t));
      next_release_ = at_ + kRowsBetweenReleases;
    }
    rows.count += n;
    return n;
  }

  void rewind() override { at_ = next_release_ = 0; }
  double progress() const override { return rows_ == 0 ? 1.0 : static_cast<double>(at_) / static_cast<double>(rows_); }
  Error shape_error(std::string what) const {
    return setpoints_error("setpoints-shape", std::move(what), {name_, 0, 0},
                           "save it with numpy.save(FILE, numpy.ascontiguousarray(TABLE, dtype='<f8'))");
  }

 private:
  /// @return whether all are finite
  bool append(std::vector<double>& out, std::size_t column, std::size_t n, double unit) {
    const std::size_t old = out.size();
    out.resize(old + n);
    double check = 0.0;  // stays 0 while all are finite
    const char* in = data_.data() + (at_ * width_ + column) * sizeof(double);
    for (std::size_t k = 0; k < n; ++k, in += width_ * sizeof(double)) {
      double value = 0.0;
      std::memcpy(&value, in, sizeof value);
      out[old + k] = value * unit;
      check += value * 0.0;
    }
    return check == 0.0;
  }

  std::uint64_t first_bad_row(std::size_t n) const {
    for (std::uint64_t row = at_; row < at_ + n; ++row) {
      for (std::uint64_t c = 0; c < width_; ++c) {
        if (!std::isfinite(little_endian<double>(data_, (row * width_ + c) * sizeof(double)))) return row;
      }
    }
    return at_;
  }

  /// @return the first row whose line is none
  std::optional<std::uint64_t> append_lines(SetpointRows& rows, std::size_t n) const {
    for (std::uint64_t row = at_; columns_.line && row < at_ + n; ++row) {
      const auto line = little_endian<std::int64_t>(lines_, row * sizeof(std::int64_t));
      if (line < 0 || line > std::numeric_limits<std::uint32_t>::max()) return row;
      rows.line.push_back(static_cast<std::uint32_t>(line));
    }
    return {};
  }

  MappedFile file_;
  std::string name_;
  std::string_view data_, lines_;
  std::uint64_t rows_ = 0, width_ = 0, at_ = 0, next_release_ = 0;
  std::size_t axes_ = 3;
};

struct ZipEntry {
  bool found = false, stored = true;
  std::string_view data;
};

/// Finds an entry through the directory at the archive's end.
/// @source PKWARE APPNOTE.TXT 6.3.10, sections 4.3.7, 4.3.12–4.3.16, 4.5.3
ZipEntry find_entry(std::string_view zip, std::string_view name) {
  const std::size_t end = zip.rfind("PK\x05\x06");
  if (end == std::string_view::npos) return {};
  std::uint64_t at = little_endian<std::uint32_t>(zip, end + 16);
  if (at == 0xFFFFFFFFU) {
    const std::size_t record = zip.rfind("PK\x06\x06", end);
    if (record == std::string_view::npos) return {};
    at = little_endian<std::uint64_t>(zip, record + 48);
  }
  while (at < zip.size() && zip.size() - at > 46 && zip.substr(at, 4) == "PK\x01\x02") {
    const std::size_t name_bytes = little_endian<std::uint16_t>(zip, at + 28);
    const std::size_t extra_bytes = little_endian<std::uint16_t>(zip, at + 30);
    const std::size_t comment_bytes = little_endian<std::uint16_t>(zip, at + 32);
    const std::uint64_t next = at + 46 + name_bytes + extra_bytes + comment_bytes;
    if (next > zip.size()) return {};
    if (zip.substr(at + 46, name_bytes) != name) {
      at = next;
      continue;
    }
    if (little_endian<std::uint16_t>(zip, at + 10) != 0) return {true, false, {}};
    std::uint64_t size = little_endian<std::uint32_t>(zip, at + 24);
    std::uint64_t offset = little_endian<std::uint32_t>(zip, at + 42);
    // The zip64 field holds, in this order, those of size, packed size and offset that do not fit above.
    std::uint64_t wide = at + 46 + name_bytes + 4;
    if (size == 0xFFFFFFFFU) size = little_endian<std::uint64_t>(zip, wide), wide += 8;
    if (little_endian<std::uint32_t>(zip, at + 20) == 0xFFFFFFFFU) wide += 8;
    if (offset == 0xFFFFFFFFU) offset = little_endian<std::uint64_t>(zip, wide);
    if (offset >= zip.size() || zip.size() - offset < 30) return {};
    const std::uint64_t data =
        offset + 30 + little_endian<std::uint16_t>(zip, offset + 26) + little_endian<std::uint16_t>(zip, offset + 28);
    if (data > zip.size() || zip.size() - data < size) return {};
    return {true, true, zip.substr(data, size)};
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<SetpointFile>> open_npy(MappedFile file, const std::string& name) {
  auto numpy = std::make_unique<NumpySetpoints>(std::move(file), name);
  if (auto fine = numpy->take(parse_array(numpy->bytes())); !fine) return tl::unexpected(fine.error());
  return numpy;
}

Result<std::unique_ptr<SetpointFile>> open_npz(MappedFile file, const std::string& name) {
  auto numpy = std::make_unique<NumpySetpoints>(std::move(file), name);
  const ZipEntry table = find_entry(numpy->bytes(), "setpoints.npy");
  const ZipEntry lines = find_entry(numpy->bytes(), "line.npy");
  if (!table.found) return tl::unexpected(numpy->shape_error("there is no whole array \"setpoints\" in it"));
  if (!table.stored || (lines.found && !lines.stored)) {
    return tl::unexpected(setpoints_error("setpoints-compressed", "the arrays are compressed", {name, 0, 0},
                                          "save them with numpy.savez, which does not compress"));
  }
  if (auto fine = numpy->take(parse_array(table.data)); !fine) return tl::unexpected(fine.error());
  if (lines.found) {
    if (auto fine = numpy->take_lines(parse_array(lines.data)); !fine) return tl::unexpected(fine.error());
  }
  return numpy;
}

}  // namespace toolpace::verify_detail
