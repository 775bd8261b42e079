#include "toolpace/nc/context.h"

namespace toolpace::nc {

void store_position(Parameters& parameters, int first, const Position& position) {
  for (std::size_t i = 0; i < kAxisCount; ++i) parameters.set_numbered(first + static_cast<int>(i), position[i]);
}

Position load_position(const Parameters& parameters, int first) {
  Position position;
  for (std::size_t i = 0; i < kAxisCount; ++i) position[i] = parameters.numbered(first + static_cast<int>(i));
  return position;
}

}  // namespace toolpace::nc
