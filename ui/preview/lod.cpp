#include "preview/lod.h"

#include <algorithm>
#include <cmath>

namespace toolpace::ui {
namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<ChunkBox> chunk_boxes(const ColouredLine& line, const Indices& kept) {
  const std::size_t count = kept.empty() ? line.vertex.size() : kept.size();
  std::vector<ChunkBox> boxes;
  for (std::size_t first = 0; first + 1 < count; first += kChunk) {
    const std::size_t last = std::min(first + kChunk, count - 1);
    ChunkBox box{line.vertex[kept.empty() ? first : kept[first]], {}};
    box.high = box.low;
    for (std::size_t j = first + 1; j <= last; ++j) {
      const auto& v = line.vertex[kept.empty() ? j : kept[j]];
      box.low = box.low.cwiseMin(v);
      box.high = box.high.cwiseMax(v);
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// Drops vertices within `radius` of the last kept one. A dropped vertex is that near to a kept one, and the piece that
/// jumps over it strays no further, so the distance to the line it came from is at most `radius`.
Indices thin_out(const ColouredLine& line, const Indices& from, float radius) {
  const std::size_t count = from.empty() ? line.vertex.size() : from.size();
  const auto at = [&](std::size_t j) { return from.empty() ? static_cast<std::uint32_t>(j) : from[j]; };
  Indices kept = {at(0)};
  const float squared = radius * radius;
  for (std::size_t j = 1; j + 1 < count; ++j) {
    const std::uint32_t i = at(j);
    const bool turns = line.style[i - 1] != line.style[i];
    if (turns || (line.vertex[i] - line.vertex[kept.back()]).squaredNorm() > squared) kept.push_back(i);
  }
  kept.push_back(at(count - 1));
  return kept;
}

struct MergedLevels {
  const ColouredLine& line;
  const Indices& kept;
  const std::vector<float>& length;  // of the full line's pieces

  std::vector<std::uint8_t> means(const std::vector<std::uint8_t>& full) const {
    std::vector<std::uint8_t> merged(kept.size() - 1);
    for (std::size_t j = 0; j + 1 < kept.size(); ++j) {
      float sum = 0, weight = 0;
      for (std::uint32_t i = kept[j]; i < kept[j + 1]; ++i) {
        sum += length[i] * static_cast<float>(full[i]);
        weight += length[i];
      }
      merged[j] = weight > 0 ? static_cast<std::uint8_t>(std::lround(sum / weight)) : full[kept[j]];
    }
    return merged;
  }

  std::vector<std::uint8_t> majorities(const std::vector<std::uint8_t>& full) const {
    std::vector<std::uint8_t> merged(kept.size() - 1);
    for (std::size_t j = 0; j + 1 < kept.size(); ++j) {
      std::array<float, 16> share = {};
      for (std::uint32_t i = kept[j]; i < kept[j + 1]; ++i) share[full[i] & 15u] += length[i];
      merged[j] = static_cast<std::uint8_t>(std::max_element(share.begin(), share.end()) - share.begin());
    }
    return merged;
  }
};

}  // namespace

std::size_t LodPyramid::level_for(double tolerance) const {
  std::size_t best = 0;
  for (std::size_t k = 1; k < levels.size(); ++k) {
    if (static_cast<double>(levels[k].tolerance) <= tolerance) best = k;
  }
  return best;
}

LodPyramid build_lod(const ColouredLine& line, double finest, double coarsest) {
  LodPyramid pyramid;
  pyramid.levels.push_back({0.0f, {}, {}, chunk_boxes(line, {})});
  if (line.pieces() < 2 * kChunk) return pyramid;

  std::vector<float> length(line.pieces());
  for (std::size_t i = 0; i < length.size(); ++i) length[i] = (line.vertex[i + 1] - line.vertex[i]).norm();
  Indices from;
  float error = 0;
  for (double radius = finest; radius <= coarsest * 1.0001; radius *= 2) {
    Indices kept = thin_out(line, from, static_cast<float>(radius));
    const std::size_t before = from.empty() ? line.vertex.size() : from.size();
    if (kept.size() * 3 > before * 2) continue;
    error += static_cast<float>(radius);
    LodLevel level{error, std::move(kept), {}, {}};
    const MergedLevels merge{line, level.vertex, length};
    for (std::size_t c = 0; c < kColourings; ++c) {
      if (line.level[c].empty()) continue;
      level.level[c] = c == line.categorical ? merge.majorities(line.level[c]) : merge.means(line.level[c]);
    }
    level.boxes = chunk_boxes(line, level.vertex);
    from = level.vertex;
    pyramid.levels.push_back(std::move(level));
    if (from.size() < 2 * kChunk) break;
  }
  return pyramid;
}

}  // namespace toolpace::ui
