#pragma once
/// A row of the table of a series, in its three forms.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json.h"
#include "series.h"

namespace toolpace::cli {

struct SeriesRow {
  std::string program;
  int exit_code = 0;
  std::string code, message;       ///< of what went wrong
  std::size_t line = 0;            ///< of the program, where that is; 0 = none
  std::vector<Json> cells;         ///< one a column
  std::string fingerprint;         ///< of all that the row was made of
  std::vector<std::string> files;  ///< sub-programs that were called
};

/// The cells of what the command printed; of nothing, if it printed nothing.
std::vector<Json> cells_of(const Json& answer, const std::vector<SeriesColumn>& columns);

/// Lines of a .csv, with their ends: program, exit_code, code, line, message, the columns, fingerprint, files (with | between). Quoted as
/// RFC 4180 has it; ends of lines within texts become blanks, so that a row is a line.
std::string csv_header(const std::vector<SeriesColumn>& columns);
std::string csv_line(const SeriesRow& row);
/// A line without its end; nothing where it is none of these.
std::optional<SeriesRow> read_csv_line(std::string_view line, const std::vector<SeriesColumn>& columns);

Json row_json(const SeriesRow& row, const std::vector<SeriesColumn>& columns);

/// For people: titles, rows, sums, one line each; columns in which nothing stands are left out.
std::string table_text(const std::vector<SeriesRow>& rows, const std::vector<SeriesColumn>& columns);

/// {"cycle_time_s": …}: the sums of those columns that have one, over the rows that have a number there; null
/// where none has.
Json sums_of(const std::vector<SeriesRow>& rows, const std::vector<SeriesColumn>& columns);

}  // namespace toolpace::cli
