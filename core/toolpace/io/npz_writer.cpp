#include <algorithm>

#include "toolpace/base/numbers.h"
#include "toolpace/io/npy_format.h"
#include "toolpace/io/setpoint_table.h"
#include "toolpace/io/writers.h"
#include "toolpace/io/zip_archive.h"

namespace toolpace::io_detail {
namespace {

constexpr std::size_t kBlockRows = 1024;

std::string json_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr std::string_view kHex = "0123456789abcdef";
      out += {'\\', 'u', '0', '0', kHex[static_cast<unsigned char>(c) >> 4U], kHex[c & 15]};
    } else {
      out += c;
    }
  }
  return out + "\"";
}

/// "setpoints" goes to the archive as it comes; "line" waits in a nameless file, since entries stand one after the
/// other.
class NpzWriter final : public SetpointWriter {
 public:
  NpzWriter(OutputFile file, SpoolFile lines, const SetpointFileOptions& options)
      : archive_(std::move(file)),
        lines_(std::move(lines)),
        table_(options.axis_derivatives),
        program_(options.program_name) {}

  Result<void> write(const Setpoints& chunk) override {
    if (auto loaded = table_.load(chunk); !loaded) return loaded;
    if (auto done = begin(); !done) return done;
    block_.resize(kBlockRows * table_.names().size());
    line_block_.resize(kBlockRows);
    for (std::size_t first = 0; first < table_.rows(); first += kBlockRows) {
      if (auto done = write_block(first, std::min(kBlockRows, table_.rows() - first)); !done) return done;
    }
    return {};
  }

  Result<void> finish() override {
    if (auto done = begin(); !done) return done;
    const std::string shape = "(" + std::to_string(rows_) + ", " + std::to_string(table_.names().size()) + ")";
    if (auto done = archive_.replace_head(npy::header("<f8", shape)); !done) return done;
    if (auto done = archive_.end_entry(); !done) return done;
    if (auto done = write_lines(); !done) return done;
    if (auto done = write_entry("meta.npy", npy::text_array(meta())); !done) return done;
    return archive_.finish();
  }

 private:
  Result<void> begin() {
    if (begun_) return {};
    begun_ = true;
    if (auto done = archive_.begin_entry("setpoints.npy", npy::kHeaderBytes); !done) return done;
    return archive_.write(npy::header("<f8", "(0, 0)"));
  }

  Result<void> write_block(std::size_t first, std::size_t rows) {
    npy::pack_rows(table_.columns(), first, rows, block_.data());
    std::copy_n(table_.lines() + first, rows, line_block_.begin());
    rows_ += rows;
    const auto* bytes = reinterpret_cast<const char*>(block_.data());
    if (auto done = archive_.write({bytes, rows * table_.names().size() * sizeof(double)}); !done) return done;
    return lines_.write({reinterpret_cast<const char*>(line_block_.data()), rows * sizeof(std::int64_t)});
  }

  Result<void> write_lines() {
    if (auto done = archive_.begin_entry("line.npy"); !done) return done;
    if (auto done = archive_.write(npy::header("<i8", "(" + std::to_string(rows_) + ",)")); !done) return done;
    auto sent = lines_.replay([this](std::string_view piece) { return archive_.write(piece); });
    return sent ? archive_.end_entry() : sent;
  }

  Result<void> write_entry(std::string_view name, std::string_view bytes) {
    if (auto done = archive_.begin_entry(name); !done) return done;
    if (auto done = archive_.write(bytes); !done) return done;
    return archive_.end_entry();
  }

  std::string meta() const {
    std::string text = "{\"columns\": [";
    for (std::size_t c = 0; c < table_.names().size(); ++c) text += (c ? ", " : "") + json_text(table_.names()[c]);
    return text + "], \"period_s\": " + to_text(table_.period()) + ", \"program\": " + json_text(program_) +
           ", \"writer\": \"toolpace\"}";
  }

  ZipArchive archive_;
  SpoolFile lines_;
  SetpointTable table_;
  std::string program_;
  bool begun_ = false;
  std::uint64_t rows_ = 0;
  std::vector<double> block_;
  std::vector<std::int64_t> line_block_;
};

}  // namespace

Result<std::unique_ptr<SetpointWriter>> make_npz_writer(OutputFile file, const SetpointFileOptions& options) {
  // Beside the target, where there is room for it; for pipes and standard output in the system's temporary directory.
  const auto directory = file.target().parent_path();
  auto lines =
      SpoolFile::create(directory.empty() || !file.is_renamed() ? std::filesystem::temp_directory_path() : directory);
  if (!lines) return tl::unexpected(lines.error());
  return std::make_unique<NpzWriter>(std::move(file), std::move(*lines), options);
}

}  // namespace toolpace::io_detail
