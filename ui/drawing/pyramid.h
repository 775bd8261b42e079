#pragma once
/// Min/max pyramid over a long row of elements: what lies between two of them costs the logarithm of the row.
///
/// Leaves summarise so many elements, each level above 8 entries of the one below, so with 64 it takes about 1/56 of an
/// extent an element. Elements themselves are not kept: queries are given a function that scans them, and the dearer that
/// is, the smaller the leaves should be.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace toolpace::ui {

/// Least and greatest of nothing yet; add() widens it.
struct Extent {
  float low = std::numeric_limits<float>::infinity(), high = -std::numeric_limits<float>::infinity();

  bool is_empty() const { return low > high; }
  void add(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const Extent& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// @tparam Summary  default-constructed = of nothing; add(Summary) widens it
/// @tparam Leaf     elements that the lowest level sums up
template <class Summary, std::size_t Leaf = 64>
class Pyramid {
 public:
  static constexpr std::size_t kLeaf = Leaf, kFanOut = 8;

  Pyramid() = default;

  /// @param scan  (first, last) -> Summary of the elements [first, last)
  template <class Scan>
  Pyramid(std::size_t count, const Scan& scan) : count_(count) {
    std::vector<Summary> level;
    level.reserve((count + kLeaf - 1) / kLeaf);
    for (std::size_t first = 0; first < count; first += kLeaf)
      level.push_back(scan(first, std::min(first + kLeaf, count)));
    while (level.size() > 1) {
      std::vector<Summary> above((level.size() + kFanOut - 1) / kFanOut);
      for (std::size_t i = 0; i < level.size(); ++i) above[i / kFanOut].add(level[i]);
      levels_.push_back(std::move(level));
      level = std::move(above);
    }
    levels_.push_back(std::move(level));
  }

  std::size_t size() const { return count_; }

  /// Summary of the elements [first, last); fewer than 2·Leaf of them are scanned.
  template <class Scan>
  Summary query(std::size_t first, std::size_t last, const Scan& scan) const {
    Summary sum;
    last = std::min(last, count_);
    if (first >= last) return sum;
    const std::size_t leaf = (first + kLeaf - 1) / kLeaf, end = last / kLeaf;
    if (leaf >= end) return scan(first, last);
    if (first < leaf * kLeaf) sum.add(scan(first, leaf * kLeaf));
    if (end * kLeaf < last) sum.add(scan(end * kLeaf, last));
    climb(leaf, end, sum);
    return sum;
  }

  /// Bytes it holds.
  std::size_t memory() const {
    std::size_t entries = 0;
    for (const auto& level : levels_) entries += level.capacity();
    return entries * sizeof(Summary);
  }

 private:
  void climb(std::size_t first, std::size_t last, Summary& sum) const {
    for (std::size_t depth = 0; first < last; ++depth) {
      const auto& level = levels_[depth];
      const bool top = depth + 1 == levels_.size();
      while (first < last && (top || first % kFanOut != 0)) sum.add(level[first++]);
      while (first < last && last % kFanOut != 0) sum.add(level[--last]);
      first /= kFanOut;
      last /= kFanOut;
    }
  }

  std::size_t count_ = 0;
  std::vector<std::vector<Summary>> levels_;  // from the leaves up
};

}  // namespace toolpace::ui
