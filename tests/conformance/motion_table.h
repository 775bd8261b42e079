#pragma once
/// Tables of motion blocks (the columns of `toolpace blocks`), read back and compared row by row.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace toolpace::test {

/// Cells by the names of their columns.
using MotionRow = std::map<std::string, std::string>;

/// The rows that do something: motion without length, tool changes, stops and the end are left out.
/// Throws std::runtime_error for what cannot be read.
std::vector<MotionRow> read_motion_table(const std::filesystem::path& file);

/// What differs, a line a row, at most ten; empty = the same motion: kinds, lines, modes and words exactly, numbers
/// within two units of the sixth decimal (feeds: digit). Error rows are compared by their lines alone.
std::string differences(const std::vector<MotionRow>& expected, const std::vector<MotionRow>& found);

}  // namespace toolpace::test
