#include "motion_table.h"

#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace toolpace::test {
namespace {

constexpr double kUnits = 2e-6;        // [mm], [deg], [s]: the reference writes six decimals
constexpr double kFeed = 1e-6;         // relative, for feeds: it writes seven digits
constexpr double kNoMove = 1e-7;       // [mm], [deg]
constexpr std::size_t kMostTold = 10;  // rows
constexpr std::array kAxes = {"x", "y", "z", "a", "b", "c"};
constexpr std::array kWords = {"line", "fmode", "plane", "path", "curve"};
constexpr std::array kNumbers = {"x",  "y",  "z",  "a",  "b",     "c",   "feed", "cx",   "cy",
                                 "cz", "nx", "ny", "nz", "sweep", "tol", "nct",  "dwell"};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

double number(const std::string& cell) { return cell.empty() ? 0.0 : std::stod(cell); }

bool does_something(const MotionRow& row, const std::array<double, kAxes.size()>& begin) {
  const std::string& kind = row.at("kind");
  if (kind == "tool" || kind == "stop" || kind == "end") return false;
  if (kind == "dwell" || kind == "error" || std::abs(number(row.at("sweep"))) > kNoMove) return true;
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    if (std::abs(number(row.at(kAxes[k])) - begin[k]) > kNoMove) return true;
  }
  return false;
}

bool are_near(const std::string& expected, const std::string& found, double relative) {
  if (expected.empty() != found.empty()) return false;
  const double wanted = number(expected);
  return std::abs(wanted - number(found)) <= kUnits + relative * std::abs(wanted);
}

std::string differences(const MotionRow& expected, const MotionRow& found) {
  std::string told;
  const auto tell = [&](const char* column) {
    told += std::string(" ") + column + " is \"" + found.at(column) + "\", not \"" + expected.at(column) + "\";";
  };
  if (expected.at("kind") != found.at("kind")) {
    tell("kind");
    return told;
  }
  if (expected.at("kind") == "error") {
    if (expected.at("line") != found.at("line")) tell("line");
    return told;
  }
  for (const char* column : kWords) {
    if (expected.at(column) != found.at(column)) tell(column);
  }
  for (const char* column : kNumbers) {
    const bool is_feed = std::string_view(column) == "feed";
    if (!are_near(expected.at(column), found.at(column), is_feed ? kFeed : 0.0)) tell(column);
  }
  return told;
}

}  // namespace

std::vector<MotionRow> read_motion_table(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  std::vector<std::string> names;
  std::vector<MotionRow> rows;
  std::array<double, kAxes.size()> place{};
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto cells = cells_of(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    if (cells.size() != names.size()) throw std::runtime_error(file.string() + ": " + line);
    MotionRow row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells[i];
    if (does_something(row, place)) rows.push_back(row);
    for (std::size_t k = 0; k < kAxes.size(); ++k) place[k] = number(row.at(kAxes[k]));
  }
  return rows;
}

std::string differences(const std::vector<MotionRow>& expected, const std::vector<MotionRow>& found) {
  std::string told;
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(expected.size(), found.size()) && count < kMostTold; ++i) {
    const std::string of_row = differences(expected[i], found[i]);
    if (of_row.empty()) continue;
    told += "row " + std::to_string(i + 1) + " (line " + expected[i].at("line") + "):" + of_row + '\n';
    ++count;
  }
  if (expected.size() != found.size()) {
    told += std::to_string(found.size()) + " rows, not " + std::to_string(expected.size()) + '\n';
  }
  return told;
}

}  // namespace toolpace::test
