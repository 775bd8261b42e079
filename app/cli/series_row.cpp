#include "series_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "toolpace/base/numbers.h"

namespace toolpace::cli {
namespace {

constexpr std::size_t kFieldsBefore = 5, kFieldsBehind = 2;
constexpr char kTogether[] = "together";
constexpr char kBetweenFiles = '|';

std::string quoted(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      const bool is_double = is_quoted && i + 1 < line.size() && line[i + 1] == '"';
      if (is_double)
        fields.back() += line[i++];
      else
        is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::optional<std::int64_t> whole(const std::string& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A cell as it was before it was written.
std::optional<Json> cell_of(const std::string& text, CellKind kind) {
  if (text.empty()) return Json();
  if (kind == CellKind::text) return Json(text);
  if (const auto value = whole(text)) return Json(*value);
  if (const auto value = parse_number(text)) return Json(*value);
  return std::nullopt;
}

std::string join_files(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += (text.empty() ? "" : std::string(1, kBetweenFiles)) + file;
  return text;
}

std::vector<std::string> split_files(const std::string& text) {
  std::vector<std::string> files;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(kBetweenFiles, at), text.size());
    files.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return files;
}

std::string shown(const Json& cell, const SeriesColumn& column) {
  const auto value = cell.number();
  if (!value || column.kind == CellKind::text) return cell.line();
  return fmt::format("{:.{}f}", *value, column.decimals);
}

bool has_figures(const SeriesRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(), [](const Json& cell) { return !cell.is_null(); });
}

Json sum_at(const Json& sums, const SeriesColumn& column) {
  const Json* const sum = sums.find(column.name);
  return sum ? *sum : Json();
}

std::string what_failed(const SeriesRow& row) {
  return (row.line > 0 ? fmt::format("line {}: ", row.line) : "") +
         (row.message.empty() ? "nothing came of it" : row.message);
}

/// Columns on the screen, not bytes: one a sequence of UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool is_left) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return is_left ? text + blanks : blanks + text;
}

}  // namespace

std::vector<Json> cells_of(const Json& answer, const std::vector<SeriesColumn>& columns) {
  std::vector<Json> cells;
  for (const SeriesColumn& column : columns) {
    const Json* found = nullptr;
    for (std::size_t i = 0; i < column.paths.size() && !found; ++i) found = answer.find(column.paths[i]);
    Json& cell = cells.emplace_back();
    if (!found || found->is_null()) continue;
    if (column.kind == CellKind::count) cell = Json(found->size());
    if (column.kind == CellKind::number) cell = *found;
    if (column.kind == CellKind::text && !found->line().empty()) cell = Json(found->line());
  }
  return cells;
}

std::string csv_header(const std::vector<SeriesColumn>& columns) {
  std::string text = "program,exit_code,code,line,message";
  for (const SeriesColumn& column : columns) text += std::string(",") + column.name;
  return text + ",fingerprint,files\n";
}

std::string csv_line(const SeriesRow& row) {
  std::string text = quoted(row.program) + ',' + std::to_string(row.exit_code) + ',' + quoted(row.code) + ',' +
                     (row.line > 0 ? std::to_string(row.line) : "") + ',' + quoted(row.message);
  for (const Json& cell : row.cells) text += ',' + quoted(cell.line());
  return text + ',' + row.fingerprint + ',' + quoted(join_files(row.files)) + '\n';
}

std::optional<SeriesRow> read_csv_line(std::string_view line, const std::vector<SeriesColumn>& columns) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const std::vector<std::string> fields = fields_of(line);
  if (fields.size() != kFieldsBefore + columns.size() + kFieldsBehind) return std::nullopt;
  const auto exit_code = whole(fields[1]);
  if (!exit_code) return std::nullopt;
  SeriesRow row{fields[0], static_cast<int>(*exit_code), fields[2], fields[4], 0, {}, {}, {}};
  if (const auto at = whole(fields[3])) row.line = static_cast<std::size_t>(*at);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    auto cell = cell_of(fields[kFieldsBefore + i], columns[i].kind);
    if (!cell) return std::nullopt;
    row.cells.push_back(std::move(*cell));
  }
  row.fingerprint = fields[fields.size() - 2];
  row.files = split_files(fields.back());
  return row;
}

Json row_json(const SeriesRow& row, const std::vector<SeriesColumn>& columns) {
  Json json = {{"program", row.program}, {"exit_code", row.exit_code}};
  json["error"] = nullptr;
  if (!row.message.empty()) json["error"] = {{"code", row.code}, {"line", row.line}, {"message", row.message}};
  for (std::size_t i = 0; i < columns.size(); ++i) json[columns[i].name] = row.cells[i];
  return json;
}

std::string table_text(const std::vector<SeriesRow>& rows, const std::vector<SeriesColumn>& all) {
  const Json sums = sums_of(rows, all);
  std::vector<std::size_t> shown_columns, width = {width_of(kTogether)};
  for (const SeriesRow& row : rows) width[0] = std::max(width[0], width_of(row.program));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool has_some =
        std::any_of(rows.begin(), rows.end(), [&](const SeriesRow& row) { return !row.cells[k].is_null(); });
    if (!has_some) continue;
    shown_columns.push_back(k);
    width.push_back(std::max(width_of(all[k].title), width_of(shown(sum_at(sums, all[k]), all[k]))));
    for (const SeriesRow& row : rows) width.back() = std::max(width.back(), width_of(shown(row.cells[k], all[k])));
  }
  const auto line_of = [&](const std::string& program, const auto& cell) {
    std::string line = padded(program, width[0], true);
    for (std::size_t i = 0; i < shown_columns.size(); ++i) {
      const std::size_t k = shown_columns[i];
      line += "  " + padded(cell(k), width[i + 1], all[k].kind == CellKind::text);
    }
    return line.erase(line.find_last_not_of(' ') + 1) + '\n';
  };
  std::string text = line_of("program", [&](std::size_t k) { return std::string(all[k].title); });
  for (const SeriesRow& row : rows) {
    text += has_figures(row) ? line_of(row.program, [&](std::size_t k) { return shown(row.cells[k], all[k]); })
                             : padded(row.program, width[0], true) + "  " + what_failed(row) + '\n';
  }
  return text + line_of(kTogether, [&](std::size_t k) { return shown(sum_at(sums, all[k]), all[k]); });
}

Json sums_of(const std::vector<SeriesRow>& rows, const std::vector<SeriesColumn>& columns) {
  Json sums = Json::object();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (!columns[k].is_summed) continue;
    double sum = 0;
    bool has_some = false;
    for (const SeriesRow& row : rows) {
      const auto value = row.cells[k].number();
      has_some |= value.has_value();
      sum += value.value_or(0.0);
    }
    sums[columns[k].name] = has_some ? Json(sum) : Json(nullptr);
  }
  return sums;
}

}  // namespace toolpace::cli
