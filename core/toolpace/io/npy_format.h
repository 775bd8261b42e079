#pragma once
/// The .npy array format, version 1.0.
/// @source NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toolpace::detail::npy {

/// Bytes that header() returns, whatever the shape, so that it can be written again when the rows are known.
inline constexpr std::size_t kHeaderBytes = 128;

/// Rows that are packed at a time: they stay in the second-level cache.
inline constexpr std::size_t kBlockRows = 1024;

/// Header of a little-endian, C-ordered array.
/// @param type   "<f8", "<i8", "<U12"
/// @param shape  "(10, 7)", "(10,)", "()"
std::string header(std::string_view type, std::string_view shape);

/// A 0-dimensional array that holds one string, UTF-8 in, UCS-4 in the file.
std::string text_array(std::string_view text);

/// Packs columns into rows of doubles: out holds rows · columns.size() values.
void pack_rows(const std::vector<const double*>& columns, std::size_t first, std::size_t rows, double* out);

}  // namespace toolpace::detail::npy
