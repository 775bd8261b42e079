#include "toolpace/verify/numpy_array.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "toolpace/verify/setpoint_readers.h"

namespace toolpace::detail {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kLengthAt = 8;                              // bytes: magic, version major and minor
constexpr std::uint64_t kLongestHeader = std::uint64_t{1} << 20;  // bytes; those of tables have some hundred
constexpr unsigned kNewestVersion = 3;

std::string_view between(std::string_view text, std::string_view after, char open, char close) {
  const std::size_t key = text.find(after);
  const std::size_t begin = key == std::string_view::npos ? key : text.find(open, key + after.size());
  const std::size_t end = begin == std::string_view::npos ? begin : text.find(close, begin + 1);
  return end == std::string_view::npos ? std::string_view{} : text.substr(begin + 1, end - begin - 1);
}

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// What the dictionary says, or what is wrong with it.
std::optional<std::string> take_dictionary(std::string_view header, NumpyArray& array) {
  if (header.find("'fortran_order': True") != std::string_view::npos) return "the array is in Fortran order";
  if (header.find("'fortran_order': False") == std::string_view::npos) return "the header says no order";
  if (header.find("'descr': [") != std::string_view::npos) return "it is an array of records";
  array.type = between(header, "'descr':", '\'', '\'');
  std::string_view shape = between(header, "'shape':", '(', ')');
  while (!shape.empty()) {
    std::uint64_t extent = 0;
    const auto [stop, error] = std::from_chars(shape.data(), shape.data() + shape.size(), extent);
    if (error != std::errc{}) return "the header says no shape";
    array.shape.push_back(extent);
    shape.remove_prefix(static_cast<std::size_t>(stop - shape.data()));
    shape.remove_prefix(std::min(shape.find_first_not_of(", "), shape.size()));
  }
  return std::nullopt;
}

}  // namespace

Error shape_error(std::string what, const std::string& name) {
  return setpoints_error("setpoints-shape", std::move(what), {name, 0, 0},
                         "save it with numpy.save(FILE, numpy.ascontiguousarray(TABLE, dtype='<f8'))");
}

/// @source NumPy Enhancement Proposal 1, versions 1.0 to 3.0
Result<NumpyArray> open_array(std::unique_ptr<ByteStream> stream, const std::string& name) {
  const auto fault = [&](std::string what) { return tl::unexpected(shape_error(std::move(what), name)); };
  constexpr const char* kNoHeader = "there is no whole header of an array";
  std::array<char, kLengthAt + 4> fixed = {};
  const std::string_view text(fixed.data(), fixed.size());
  if (stream->size() < fixed.size()) return fault(kNoHeader);
  if (auto read = stream->read(fixed.data(), kLengthAt); !read) return tl::unexpected(std::move(read.error()));
  if (!text.starts_with(kMagic)) return fault(kNoHeader);
  const unsigned major = static_cast<unsigned char>(text[6]), minor = static_cast<unsigned char>(text[7]);
  if (major < 1 || major > kNewestVersion || minor != 0) {
    return fault("it is of version " + std::to_string(major) + "." + std::to_string(minor) +
                 " of the format, and those known are 1.0, 2.0 and 3.0");
  }
  const std::size_t length_bytes = major == 1 ? 2 : 4;
  if (auto read = stream->read(fixed.data() + kLengthAt, length_bytes); !read) {
    return tl::unexpected(std::move(read.error()));
  }
  const std::uint64_t length = little_endian(text.substr(kLengthAt, length_bytes));
  const std::uint64_t begin = kLengthAt + length_bytes;
  if (length > kLongestHeader || begin + length > stream->size()) return fault(kNoHeader);
  std::string header(static_cast<std::size_t>(length), '\0');
  if (auto read = stream->read(header.data(), header.size()); !read) return tl::unexpected(std::move(read.error()));
  NumpyArray array;
  if (auto wrong = take_dictionary(header, array)) return fault(std::move(*wrong));
  array.header_bytes = static_cast<std::size_t>(begin + length);
  array.bytes = stream->size() - array.header_bytes;
  array.stream = std::move(stream);
  return array;
}

Result<void> NumpyArray::seek_values() {
  stream->rewind();
  std::string header(header_bytes, '\0');
  return stream->read(header.data(), header.size());
}

std::string NumpyArray::size_fault(std::uint64_t rows, std::uint64_t columns) const {
  const std::uint64_t row_bytes = std::max<std::uint64_t>(1, columns) * sizeof(double);
  const std::uint64_t whole = bytes / row_bytes;
  if (columns == 0 ? rows == 0 : rows == whole && bytes % row_bytes == 0) return "";
  if (columns != 0 && rows <= whole) {
    return std::to_string(bytes - rows * row_bytes) + " bytes stand behind its " + std::to_string(rows) + " rows";
  }
  return "it is cut short: " + std::to_string(rows) + " rows of " + std::to_string(columns) +
         " columns are due, and there are " + std::to_string(whole);
}

}  // namespace toolpace::detail
