#include "series.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_map>

#include "console.h"
#include "interrupt.h"
#include "report.h"
#include "results_file.h"
#include "series_console.h"
#include "series_fingerprint.h"
#include "series_programs.h"
#include "series_row.h"
#include "toolpace/base/error_text.h"
#include "toolpace/base/file_error.h"
#include "toolpace/io/output_file.h"
#include "toolpace/pipeline/many.h"

namespace toolpace::cli {
namespace {

constexpr std::uint64_t kMostJobs = 4096;

std::vector<std::string> words_for(const Series& series, const std::string& program) {
  std::vector<std::string> words = {series.command, "--json"};
  for (const GivenFlag& flag : series.given) {
    const std::string value = flag.is_output ? filled(flag.value, program) : flag.value;
    words.push_back(flag.name + (value.empty() ? "" : "=" + value));
  }
  words.insert(words.end(), {"--", program});
  return words;
}

bool has_outputs(const Series& series, const std::string& program) {
  return std::all_of(series.given.begin(), series.given.end(), [&](const GivenFlag& flag) {
    std::error_code none;
    return !flag.is_output || std::filesystem::exists(filled(flag.value, program), none);
  });
}

/// The work on all programs: each made anew, or taken from the results file.
class SeriesRun {
 public:
  SeriesRun(const Series& series, std::vector<std::string> programs, Fingerprint shared)
      : series_(series), programs_(std::move(programs)), shared_(shared), outer_(console()) {
    rows_.resize(programs_.size());
  }

  /// The rows of an earlier run. Errors: of ResultsFile; usage where they are of another table.
  Result<void> open_results(const std::stop_token& stop);

  /// Errors: what ends the series.
  tl::expected<void, Failure> work(const Monitor& monitor);

  /// Those that are done, in the order of the programs.
  std::vector<SeriesRow> rows() const;
  std::size_t taken_over() const { return taken_over_; }

 private:
  struct Nothing {};
  Result<Nothing> work_at(std::size_t i, const std::stop_token& stop);
  std::optional<SeriesRow> kept_row(const std::string& program, const std::stop_token& stop) const;
  std::string fingerprint_with(const std::string& program, const std::vector<std::string>& files,
                               const std::stop_token& stop) const;
  SeriesRow make_row(const std::string& program, const SeriesConsole& said, const Done& done) const;
  bool is_of_all(const Error& error) const;
  Result<Nothing> end_by(Failure failure);
  bool is_ended();
  void tell_outside(const std::string& text) const;

  const Series& series_;
  std::vector<std::string> programs_;
  Fingerprint shared_;
  Console* outer_;  ///< who hears what the series says; null = the terminal
  std::optional<ResultsFile> results_;
  std::unordered_map<std::string, SeriesRow> kept_;
  std::mutex mutex_;
  std::vector<std::optional<SeriesRow>> rows_;
  std::size_t taken_over_ = 0;
  std::optional<Failure> ended_by_;
};

Result<void> SeriesRun::open_results(const std::stop_token& stop) {
  const std::string& name = series_.flags.results;
  if (name.empty()) return {};
  auto file = ResultsFile::open(name, stop);
  if (!file) return tl::unexpected(file.error());
  const auto lines = file->lines();
  if (!lines) return tl::unexpected(lines.error());
  std::string header = csv_header(series_.flags.columns);
  header.pop_back();
  if (!lines->empty() && lines->front() != header) {
    return tl::unexpected(usage_error("results-of-others", name + " is no table of results of " + series_.command,
                                      "give --results the name of another file"));
  }
  for (const std::string& line : *lines) {
    if (auto row = read_csv_line(line, series_.flags.columns)) kept_.insert_or_assign(row->program, std::move(*row));
  }
  results_.emplace(std::move(*file));
  return {};
}

/// Empty where one of the files cannot be read: such a row is made again.
std::string SeriesRun::fingerprint_with(const std::string& program, const std::vector<std::string>& files,
                                        const std::stop_token& stop) const {
  Fingerprint fingerprint = shared_;
  std::error_code none;
  if (!std::filesystem::is_regular_file(program, none)) return "";
  if (!fingerprint.add_file(program, {stop, {}})) return "";
  for (const std::string& file : files) {
    fingerprint.add(file);
    if (!fingerprint.add_file(file, {stop, {}})) return "";
  }
  return fingerprint.digits();
}

/// What was done, and would come out the same again. What failed is tried again: it may be something outside that has changed.
std::optional<SeriesRow> SeriesRun::kept_row(const std::string& program, const std::stop_token& stop) const {
  const auto found = kept_.find(program);
  if (found == kept_.end() || found->second.exit_code > kLimitBroken || found->second.fingerprint.empty()) return {};
  const SeriesRow& row = found->second;
  if (row.fingerprint != fingerprint_with(program, row.files, stop) || !has_outputs(series_, program)) return {};
  return row;
}

SeriesRow SeriesRun::make_row(const std::string& program, const SeriesConsole& said, const Done& done) const {
  SeriesRow row{program, done ? *done : exit_code(done.error().error.kind), {}, {}, 0, {}, {}, {}};
  const bool has_failed =
      row.exit_code > kLimitBroken;  // what is told of the part of a program before its error is no figure of it
  row.cells = cells_of(has_failed ? Json() : said.answered, series_.flags.columns);
  if (!said.files.empty()) row.files.assign(said.files.begin() + 1, said.files.end());
  if (has_failed && said.first_error) {
    row.code = said.first_error->code;
    row.message = said.first_error->message;
    row.line = said.first_error->where.line;
  } else if (!done) {
    row.code = done.error().error.code;
    row.message = done.error().error.message;
    row.line = done.error().error.where.line;
  }
  return row;
}

/// Whether the other programs would end by it, too.
bool SeriesRun::is_of_all(const Error& error) const {
  return error.kind == ErrorKind::usage ||
         std::any_of(series_.inputs.begin(), series_.inputs.end(), [&](const FileRole& input) {
           return !input.file.empty() && error.where.file == input.file.string();
         });
}

Result<SeriesRun::Nothing> SeriesRun::end_by(Failure failure) {
  const std::scoped_lock lock(mutex_);
  if (!ended_by_) ended_by_.emplace(std::move(failure));
  return tl::unexpected(ended_by_->error);
}

bool SeriesRun::is_ended() {
  const std::scoped_lock lock(mutex_);
  return ended_by_.has_value();
}

void SeriesRun::tell_outside(const std::string& text) const {
  if (text.empty()) return;
  if (outer_) return outer_->tell(text);
  std::fputs(text.c_str(), stderr);
}

Result<SeriesRun::Nothing> SeriesRun::work_at(std::size_t i, const std::stop_token& stop) {
  if (is_ended()) return tl::unexpected(cancelled_error());
  const std::string& program = programs_[i];
  if (auto kept = kept_row(program, stop)) {
    const std::scoped_lock lock(mutex_);
    rows_[i] = std::move(*kept);
    ++taken_over_;
    return Nothing{};
  }
  const std::string before = fingerprint_with(program, {}, stop);
  SeriesConsole said(stop);
  const Done done = run_words(words_for(series_, program), said);
  if (!done && done.error().error.kind == ErrorKind::cancelled) return tl::unexpected(done.error().error);
  if (!done && is_of_all(done.error().error)) return end_by(done.error());
  SeriesRow row = make_row(program, said, done);
  if (before == fingerprint_with(program, {}, stop)) row.fingerprint = fingerprint_with(program, row.files, stop);
  if (results_) {
    const std::scoped_lock lock(mutex_);
    const auto kept = results_->append(csv_header(series_.flags.columns), csv_line(row));
    if (!kept && !ended_by_) ended_by_.emplace(kept.error());
    if (!kept) return tl::unexpected(kept.error());
  }
  const std::scoped_lock lock(mutex_);
  if (!outer_) end_progress();
  tell_outside(said.told + (done ? "" : error_text(done.error().error)));
  rows_[i] = std::move(row);
  return Nothing{};
}

tl::expected<void, Failure> SeriesRun::work(const Monitor& monitor) {
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const SeriesFlags& flags = series_.flags;
  const std::size_t jobs = flags.jobs > 0 ? flags.jobs : flags.fills_cores ? 1 : cores;
  const auto one = [&](std::size_t i, const Monitor& quiet) { return work_at(i, quiet.stop); };
  const auto done = for_many<Nothing>(programs_.size(), jobs, monitor, one);
  if (ended_by_) return tl::unexpected(*ended_by_);
  if (!done) return tl::unexpected<Failure>(done.error());
  return {};
}

std::vector<SeriesRow> SeriesRun::rows() const {
  std::vector<SeriesRow> rows;
  for (const auto& row : rows_) {
    if (row) rows.push_back(*row);
  }
  return rows;
}

std::size_t failed_of(const std::vector<SeriesRow>& rows) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const SeriesRow& row) { return row.exit_code > kLimitBroken; }));
}

void print_series(const Series& series, const std::vector<SeriesRow>& rows, std::size_t taken_over) {
  std::string text = table_text(rows, series.flags.columns);
  text += fmt::format("{} programs, {} failed", rows.size(), failed_of(rows));
  if (!series.flags.results.empty()) text += fmt::format(", {} taken over from {}", taken_over, series.flags.results);
  text += '\n';
  fmt::print("{}", text);
}

Json series_json(const Series& series, const std::vector<SeriesRow>& rows, std::size_t taken_over) {
  Json list = Json::array();
  for (const SeriesRow& row : rows) list.push_back(row_json(row, series.flags.columns));
  return {{"command", series.command},
          {"programs", rows.size()},
          {"failed", failed_of(rows)},
          {"taken_over", taken_over},
          {"sums", sums_of(rows, series.flags.columns)},
          {"rows", std::move(list)}};
}

Result<void> write_table(OutputFile& file, const Series& series, const std::vector<SeriesRow>& rows) {
  std::string text = csv_header(series.flags.columns);
  for (const SeriesRow& row : rows) text += csv_line(row);
  if (auto written = file.write(text); !written) return written;
  return file.commit();
}

}  // namespace

Done run_series(const Series& series) {
  const SeriesFlags& flags = series.flags;
  if (flags.jobs > kMostJobs)
    return tl::unexpected(
        usage_error("bad-flag", fmt::format("--jobs is {}, but must be at most {}", flags.jobs, kMostJobs), ""));
  const auto programs = programs_of(flags);
  if (!programs) return tl::unexpected(programs.error());
  if (auto apart = check_series_outputs(series, *programs); !apart) return tl::unexpected(apart.error());
  const Monitor monitor = terminal_monitor("programs");
  const auto shared = fingerprint_of(series, monitor);
  if (!shared) return tl::unexpected(shared.error());
  SeriesRun run(series, *programs, *shared);
  if (auto opened = run.open_results(monitor.stop); !opened) return tl::unexpected(opened.error());
  std::optional<OutputFile> table;
  if (!flags.csv.empty()) {
    auto opened = OutputFile::create(flags.csv, OutputFile::Access::forward, monitor);
    if (!opened) return tl::unexpected(opened.error());
    table.emplace(std::move(*opened));
  }
  const auto worked = run.work(monitor);
  end_progress();
  const std::vector<SeriesRow> rows = run.rows();
  const bool is_shown = !series.json && !is_standard_output(flags.csv);
  if (is_shown && !rows.empty()) print_series(series, rows, run.taken_over());
  if (!worked) return tl::unexpected(worked.error());
  if (table) {
    if (auto written = write_table(*table, series, rows); !written) return tl::unexpected(written.error());
  }
  if (series.json) print_json(series_json(series, rows, run.taken_over()));
  int worst = kFine;
  for (const SeriesRow& row : rows) worst = std::max(worst, row.exit_code);
  return static_cast<ExitCode>(worst);
}

}  // namespace toolpace::cli
