#include "drawing/lod.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toolpace::ui {
namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<ChunkBox> chunk_boxes(const SceneLine& line, const Indices& kept) {
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
Indices thin_out(const SceneLine& line, const Indices& from, float radius) {
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

float length_of(const SceneLine& line, std::size_t piece) {
  return (line.vertex[piece + 1] - line.vertex[piece]).norm();
}

}  // namespace

std::size_t LodPyramid::level_for(double tolerance) const {
  std::size_t best = 0;
  for (std::size_t k = 1; k < levels.size(); ++k) {
    if (static_cast<double>(levels[k].tolerance) <= tolerance) best = k;
  }
  return best;
}

LodPyramid build_lod(const SceneLine& line, double finest, double coarsest) {
  LodPyramid pyramid;
  pyramid.levels.push_back({0.0f, {}, chunk_boxes(line, {})});
  if (line.pieces() < 2 * kChunk) return pyramid;
  float error = 0;
  for (double radius = finest; radius <= coarsest * 1.0001; radius *= 2) {
    const Indices& from = pyramid.levels.back().vertex;
    Indices kept = thin_out(line, from, static_cast<float>(radius));
    const std::size_t before = from.empty() ? line.vertex.size() : from.size();
    if (kept.size() * 3 > before * 2) continue;
    error += static_cast<float>(radius);
    kept.shrink_to_fit();
    auto boxes = chunk_boxes(line, kept);
    pyramid.levels.push_back({error, std::move(kept), std::move(boxes)});
    if (pyramid.levels.back().vertex.size() < 2 * kChunk) break;
  }
  return pyramid;
}

std::vector<std::uint8_t> merged_means(const SceneLine& line, const LodLevel& level,
                                       const std::vector<std::uint8_t>& full) {
  std::vector<std::uint8_t> merged(level.vertex.size() - 1);
  for (std::size_t j = 0; j < merged.size(); ++j) {
    float sum = 0, weight = 0;
    for (std::uint32_t i = level.vertex[j]; i < level.vertex[j + 1]; ++i) {
      const float length = length_of(line, i);
      sum += length * static_cast<float>(full[i]);
      weight += length;
    }
    merged[j] = weight > 0 ? static_cast<std::uint8_t>(sum / weight + 0.5f) : full[level.vertex[j]];
  }
  return merged;
}

std::vector<std::uint8_t> merged_majorities(const SceneLine& line, const LodLevel& level,
                                            const std::vector<std::uint8_t>& full) {
  std::vector<std::uint8_t> merged(level.vertex.size() - 1);
  for (std::size_t j = 0; j < merged.size(); ++j) {
    std::array<float, 16> share = {};
    for (std::uint32_t i = level.vertex[j]; i < level.vertex[j + 1]; ++i) share[full[i] & 15u] += length_of(line, i);
    merged[j] = static_cast<std::uint8_t>(std::max_element(share.begin(), share.end()) - share.begin());
  }
  return merged;
}

}  // namespace toolpace::ui
