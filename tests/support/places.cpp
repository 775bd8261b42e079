#include "places.h"

namespace toolpace::test {

std::filesystem::path source_dir() { return TOOLPACE_SOURCE_DIR; }

}  // namespace toolpace::test
