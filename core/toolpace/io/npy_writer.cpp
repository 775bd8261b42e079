#include <bit>
#include <cstring>

#include "toolpace/io/npy_format.h"
#include "toolpace/io/setpoint_table.h"
#include "toolpace/io/writers.h"

namespace toolpace {
namespace detail::npy {
namespace {

static_assert(std::endian::native == std::endian::little, "the writers put native doubles into little-endian files");

/// UTF-8 to code points; bytes that are no UTF-8 become U+FFFD.
std::u32string code_points(std::string_view text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80 ? 0 : lead >= 0xF0 && lead < 0xF5 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC2 ? 1 : -1;
    char32_t point = more <= 0 ? lead : lead & (0x3FU >> more);
    bool valid = more >= 0 && lead < 0xF5;
    for (int k = 0; valid && k < more; ++k) {
      valid = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
      if (valid) point = point << 6U | (static_cast<unsigned char>(text[i++]) & 0x3FU);
    }
    const bool surrogate = point >= 0xD800 && point < 0xE000;
    out.push_back(valid && !surrogate && point < 0x110000 ? point : U'\uFFFD');
  }
  return out;
}

}  // namespace

std::string header(std::string_view type, std::string_view shape) {
  std::string text("\x93NUMPY\x01\x00\x76\x00", 10);  // magic, version 1.0, 118 bytes of dictionary
  text.append("{'descr': '").append(type).append("', 'fortran_order': False, 'shape': ").append(shape).append(", }");
  text.resize(kHeaderBytes - 1, ' ');
  text.push_back('\n');
  return text;
}

std::string text_array(std::string_view text) {
  const std::u32string points = code_points(text);
  std::string out = header("<U" + std::to_string(points.size()), "()");
  out.append(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(char32_t));
  return out;
}

void pack_rows(const std::vector<const double*>& columns, std::size_t first, std::size_t rows, double* out) {
  const std::size_t width = columns.size();
  for (std::size_t c = 0; c < width; ++c) {
    const double* const in = columns[c] + first;
    for (std::size_t k = 0; k < rows; ++k) out[k * width + c] = in[k];
  }
}

}  // namespace detail::npy

namespace detail {
namespace {

class NpyWriter final : public SetpointWriter {
 public:
  NpyWriter(OutputFile file, const SetpointFileOptions& options)
      : file_(std::move(file)), table_(options.axis_derivatives) {}

  Result<void> write(const Setpoints& chunk) override {
    if (auto loaded = table_.load(chunk); !loaded) return loaded;
    if (block_.empty()) {
      block_.resize(npy::kBlockRows * table_.names().size());
      if (auto done = file_.write(header()); !done) return done;
    }
    for (std::size_t first = 0; first < table_.rows(); first += npy::kBlockRows) {
      const std::size_t rows = std::min(npy::kBlockRows, table_.rows() - first);
      npy::pack_rows(table_.columns(), first, rows, block_.data());
      const auto* bytes = reinterpret_cast<const char*>(block_.data());
      if (auto done = file_.write({bytes, rows * table_.names().size() * sizeof(double)}); !done) return done;
      rows_ += rows;
    }
    return {};
  }

  Result<void> finish() override {
    if (block_.empty()) {
      if (auto done = file_.write(header()); !done) return done;
    } else if (auto done = file_.overwrite(0, header()); !done) {
      return done;
    }
    return file_.commit();
  }

 private:
  std::string header() const {
    return npy::header("<f8", "(" + std::to_string(rows_) + ", " + std::to_string(table_.names().size()) + ")");
  }

  OutputFile file_;
  SetpointTable table_;
  std::uint64_t rows_ = 0;
  std::vector<double> block_;
};

}  // namespace

MadeWriter make_npy_writer(OutputFile file, const SetpointFileOptions& options) {
  return std::make_unique<NpyWriter>(std::move(file), options);
}

}  // namespace detail
}  // namespace toolpace
