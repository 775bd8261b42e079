#include "places.h"

namespace toolpace::test {

std::filesystem::path source_dir() { return TOOLPACE_SOURCE_DIR; }
std::filesystem::path shared_dir() { return source_dir().parent_path() / "shared"; }

}  // namespace toolpace::test
