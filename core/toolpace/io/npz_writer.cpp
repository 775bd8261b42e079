#include <algorithm>

#include "toolpace/base/numbers.h"
#include "toolpace/io/npy_format.h"
#include "toolpace/io/setpoint_table.h"
#include "toolpace/io/writers.h"
#include "toolpace/io/zip_writer.h"
#include "toolpace/limits/corner_names.h"

namespace toolpace::detail {
namespace {

constexpr double kAnyStep = 1e300;  // [mm/s] for infinite, which JSON has no number for

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

/// The rows wait in nameless files: the entries of an archive stand one after the other, and their sizes before them.
class NpzWriter final : public SetpointWriter {
 public:
  NpzWriter(OutputFile file, SpoolFile rows, SpoolFile lines, const SetpointFileOptions& options)
      : file_(std::move(file)),
        row_file_(std::move(rows)),
        line_file_(std::move(lines)),
        table_(options.axis_derivatives),
        program_(options.program_name) {}

  Result<void> write(const Setpoints& chunk) override {
    if (auto loaded = table_.load(chunk); !loaded) return loaded;
    block_.resize(npy::kBlockRows * table_.names().size());
    line_block_.resize(npy::kBlockRows);
    for (std::size_t first = 0; first < table_.rows(); first += npy::kBlockRows) {
      if (auto done = write_block(first, std::min(npy::kBlockRows, table_.rows() - first)); !done) return done;
    }
    return {};
  }

  Result<void> finish() override {
    const std::string rows = std::to_string(rows_);
    const std::string shape = "(" + rows + ", " + std::to_string(table_.names().size()) + ")";
    return write_zip(file_, {{"setpoints.npy", npy::header("<f8", shape), &row_file_},
                             {"line.npy", npy::header("<i8", "(" + rows + ",)"), &line_file_},
                             {"meta.npy", npy::text_array(meta()), nullptr}});
  }

 private:
  Result<void> write_block(std::size_t first, std::size_t rows) {
    npy::pack_rows(table_.columns(), first, rows, block_.data());
    std::copy_n(table_.lines() + first, rows, line_block_.begin());
    rows_ += rows;
    const auto* bytes = reinterpret_cast<const char*>(block_.data());
    if (auto done = row_file_.write({bytes, rows * table_.names().size() * sizeof(double)}); !done) return done;
    return line_file_.write({reinterpret_cast<const char*>(line_block_.data()), rows * sizeof(std::int64_t)});
  }

  std::string meta() const {
    std::string text = "{\"columns\": [";
    for (std::size_t c = 0; c < table_.names().size(); ++c) text += (c ? ", " : "") + json_text(table_.names()[c]);
    return text + "], \"period_s\": " + to_text(table_.period()) + ", \"program\": " + json_text(program_) +
           plan_text() + ", \"writer\": \"toolpace\"}";
  }

  /// What verification asks of the plan.
  std::string plan_text() const {
    std::string text;
    if (!origin_.law.empty()) text += ", \"law\": " + json_text(origin_.law);
    if (!origin_.shaper.empty()) text += ", \"shaper\": " + json_text(origin_.shaper);
    if (!origin_.corner) return text;
    const CornerOptions& corner = *origin_.corner;
    text += ", \"corner\": " + json_text(corner_rule_name(corner.rule));
    if (corner.step) text += ", \"corner_step_mm_s\": " + to_text(std::min(*corner.step, kAnyStep));
    text += ", \"tolerance_mm\": " + to_text(corner.tolerance) +
            ", \"junction_deviation_mm\": " + to_text(corner.junction_deviation);
    return text + ", \"path_control\": " + (origin_.has_path_control ? "true" : "false");
  }

  OutputFile file_;
  SpoolFile row_file_, line_file_;
  SetpointTable table_;
  std::string program_;
  std::uint64_t rows_ = 0;
  std::vector<double> block_;
  std::vector<std::int64_t> line_block_;
};

}  // namespace

MadeWriter make_npz_writer(OutputFile file, const SetpointFileOptions& options) {
  // Beside the target, where there is room for it; for pipes and standard output in the system's temporary directory.
  const auto create = [&] {
    return file.is_renamed() ? SpoolFile::create(file.target().parent_path()) : SpoolFile::create_anywhere();
  };
  auto rows = create();
  if (!rows) return tl::unexpected(std::move(rows.error()));
  auto lines = create();
  if (!lines) return tl::unexpected(std::move(lines.error()));
  return std::make_unique<NpzWriter>(std::move(file), std::move(*rows), std::move(*lines), options);
}

}  // namespace toolpace::detail
