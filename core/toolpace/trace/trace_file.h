#pragma once
/// A measured trace, read row by row in bounded memory.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/trace/trace_columns.h"

namespace toolpace {

struct TraceOptions {
  std::vector<TraceMapping> columns = {};  ///< empty = guessed
  std::optional<double> step = {};         ///< [s] from row to row where no column tells the time
};

/// Consecutive rows, column by column; empty where the file has none.
struct TraceRows {
  std::vector<double> time;                               ///< [s]
  std::array<std::vector<double>, kAxisCount> actual;     ///< [mm, rad]
  std::array<std::vector<double>, kAxisCount> commanded;  ///< as the trace itself recorded them
};

/// Any table of numbers with names above: separated by commas, semicolons, tabs or blanks, decimal point or comma, with
/// whatever stands above it; the export of TwinCAT Scope; the plain columns of LinuxCNC's halsampler, with or without -t.
class TraceFile {
 public:
  /// "-" = standard input. Errors: io; cancelled; usage and input: trace-empty, trace-broken, trace-columns, trace-time.
  static Result<TraceFile> open(const std::filesystem::path& file, const TraceOptions& options,
                                const Monitor& monitor = {});
  TraceFile(TraceFile&&) noexcept;
  TraceFile& operator=(TraceFile&&) noexcept;
  ~TraceFile();

  /// All columns of the file, and what each was taken for.
  const std::vector<TraceColumn>& columns() const;
  bool has(TraceRole role, std::size_t axis) const;
  /// Line of the file that holds a row.
  std::size_t line_of(std::size_t row) const;

  /// Appends up to `limit` rows. @return how many; 0 = no more
  /// Errors: io; input: trace-broken (no number, a row that is too short), trace-number (nan, inf), trace-gap (samples that
  /// halsampler lost), each with its line and column.
  Result<std::size_t> read(TraceRows& rows, std::size_t limit);

  /// How much has been read, 0 … 1.
  double progress() const;

 private:
  struct Inside;
  explicit TraceFile(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// What a file holds, before anybody has said what its columns mean.
struct TracePreview {
  std::vector<TraceColumn> columns;       ///< as they are guessed
  std::vector<std::vector<double>> rows;  ///< the first ones, as numbers of the file
};

/// Errors: io; cancelled; input: trace-empty, trace-broken.
Result<TracePreview> preview_trace(const std::filesystem::path& file, const Monitor& monitor = {});

}  // namespace toolpace
